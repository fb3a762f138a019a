#include "dem_server/coupling_points.hpp"

#include <fmt/format.h>

#include <bit>
#include <stdexcept>
#include <unordered_map>

namespace adit::dem {
namespace {

struct Key {
  std::uint64_t x, y;
  bool operator==(const Key&) const = default;
};

struct Hash {
  std::size_t operator()(const Key& key) const { return key.x * 0x9e3779b97f4a7c15ull ^ key.y; }
};

Key key_of(double x, double y) {
  return {std::bit_cast<std::uint64_t>(x), std::bit_cast<std::uint64_t>(y)};
}

}  // namespace

std::vector<double> CouplingPoints::offer(const Particles& p, const Rectangle& box) {
  offered_.clear();
  std::vector<double> centres;
  for (std::uint32_t i = 0; i < p.size(); ++i) {
    if (p.x[i] < box.x_min || p.x[i] > box.x_max || p.y[i] < box.y_min || p.y[i] > box.y_max) continue;
    offered_.push_back(i);
    centres.push_back(p.x[i]);
    centres.push_back(p.y[i]);
  }
  return centres;
}

void CouplingPoints::tie(std::span<const double> points, const Particles& p, const Motions& motions) {
  if (points.size() % 2 != 0) throw std::logic_error("couple: the coupling points are not pairs of x and y");
  std::unordered_map<Key, std::uint32_t, Hash> free_particles;
  for (const std::uint32_t i : offered_) free_particles.emplace(key_of(p.x[i], p.y[i]), i);
  particles_.clear();
  inverse_masses_.clear();
  for (std::size_t k = 0; k < points.size(); k += 2) {
    const auto found = free_particles.find(key_of(points[k], points[k + 1]));
    if (found == free_particles.end())
      throw std::logic_error(
          fmt::format("couple: point {} at ({:.17g}, {:.17g}) m is not a particle centre that "
                      "was offered, or comes twice; send back offered points unchanged",
                      k / 2, points[k], points[k + 1]));
    const std::uint32_t i = found->second;
    free_particles.erase(found);
    particles_.push_back(i);
    inverse_masses_.push_back(motions.prescribes_x(i) ? 0.0 : p.inverse_mass[i]);
    inverse_masses_.push_back(motions.prescribes_y(i) ? 0.0 : p.inverse_mass[i]);
  }
}

void CouplingPoints::push(std::span<const double> impulses, Particles& p) const {
  for (std::size_t k = 0; k < particles_.size(); ++k) {
    p.vx[particles_[k]] += impulses[2 * k] * inverse_masses_[2 * k];
    p.vy[particles_[k]] += impulses[2 * k + 1] * inverse_masses_[2 * k + 1];
  }
}

void CouplingPoints::read_velocities(const Particles& p, std::span<double> velocities) const {
  for (std::size_t k = 0; k < particles_.size(); ++k) {
    velocities[2 * k] = p.vx[particles_[k]];
    velocities[2 * k + 1] = p.vy[particles_[k]];
  }
}

}  // namespace adit::dem
