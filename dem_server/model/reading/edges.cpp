#include "dem_server/model/reading/edges.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace adit::dem {
namespace {

struct Impedance {
  double across, along;  // rho c_p, rho c_s [kg/(m^2 s)]
};

Impedance impedance(const scene::Material& material, Plane plane) {
  const double e = material.young_modulus(), nu = material.poisson_ratio(), rho = material.density();
  const double modulus =
      plane == Plane::kStress ? e / (1 - nu * nu) : e * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  return {std::sqrt(rho * modulus), std::sqrt(rho * e / (2 * (1 + nu)))};
}

// The length of the side that each of the chosen discs stands for [m].
std::vector<double> shares(const std::vector<std::uint32_t>& chosen, const std::vector<double>& along,
                           const std::vector<double>& radius) {
  std::vector<std::size_t> order(chosen.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return along[chosen[k]]; });
  std::vector<double> share(chosen.size(), 0.0);
  const auto add = [&](std::size_t k, double to_next) {
    const double r = radius[chosen[k]];
    share[k] += to_next <= 4 * r ? to_next / 2 : r;
  };
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const double to_next = along[chosen[order[k + 1]]] - along[chosen[order[k]]];
    add(order[k], to_next);
    add(order[k + 1], to_next);
  }
  for (const std::size_t end : {order.front(), order.back()}) share[end] += radius[chosen[end]];
  return share;
}

}  // namespace

std::vector<EdgeDashpot> read_edges(const scene::Particles& particles, const std::vector<Group>& groups,
                                    const Placement& placement, const std::vector<std::uint32_t>& group) {
  std::map<std::uint32_t, EdgeDashpot> by_disc;
  const auto& [x, y, radius] = placement.discs;
  for (int k = 0; k < particles.quiet_size(); ++k) {
    const auto& quiet = particles.quiet(k);
    const bool upright =
        quiet.side() == scene::QuietParticles::LEFT || quiet.side() == scene::QuietParticles::RIGHT;
    const auto chosen = select(quiet.where(), placement, "particles.quiet[" + std::to_string(k) + "].where");
    const auto share = shares(chosen, upright ? y : x, radius);
    for (std::size_t n = 0; n < chosen.size(); ++n) {
      const Group& of = groups[group[chosen[n]]];
      const auto [across, along] = impedance(of.material.material, of.plane);
      EdgeDashpot& edge = by_disc.try_emplace(chosen[n], EdgeDashpot{chosen[n], 0, 0}).first->second;
      edge.damping_x += share[n] * (upright ? across : along);
      edge.damping_y += share[n] * (upright ? along : across);
    }
  }
  std::vector<EdgeDashpot> edges;
  for (const auto& [disc, edge] : by_disc) edges.push_back(edge);
  return edges;
}

}  // namespace adit::dem
