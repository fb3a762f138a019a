#include "dem_server/particles/assembly.hpp"

#include <algorithm>
#include <atomic>
#include <limits>

#include "protocol/threads/index_ranges.hpp"

namespace adit::dem {
namespace {

constexpr std::uint32_t kVanished = std::numeric_limits<std::uint32_t>::max();

// Particles that exist; new_place[i] becomes particle i's index among them, or kVanished.
Particles keep_particles(const Packing& packing, std::span<const double> centre_weights,
                         std::vector<std::uint32_t>& new_place) {
  Particles p;
  new_place.assign(packing.x.size(), kVanished);
  for (std::size_t i = 0; i < packing.x.size(); ++i) {
    if (centre_weights[i] == 0) continue;
    new_place[i] = static_cast<std::uint32_t>(p.size());
    p.id.push_back(static_cast<std::uint32_t>(i));
    p.x.push_back(packing.x[i]);
    p.y.push_back(packing.y[i]);
  }
  for (auto* zeroed :
       {&p.ux, &p.uy, &p.settled_x, &p.settled_y, &p.vx, &p.vy, &p.spin, &p.fx, &p.fy, &p.moment, &p.weight})
    zeroed->assign(p.size(), 0.0);
  return p;
}

void append_to_runs(std::vector<Run>& runs, std::uint32_t bond, std::uint32_t first, std::uint32_t second,
                    double rest_x, double rest_y) {
  if (!runs.empty()) {
    Run& last = runs.back();
    if (last.count < kLongestRun && first == last.first + last.count && second == last.second + last.count &&
        rest_x == last.rest_x && rest_y == last.rest_y) {
      ++last.count;
      return;
    }
  }
  runs.push_back({bond, 1, first, second, rest_x, rest_y});
}

Bonds keep_bonds(const Packing& packing, const SampledWeights& weights,
                 const std::vector<std::uint32_t>& new_place) {
  Bonds b;
  b.rest_length = 2 * packing.radius;
  std::vector<double> midpoint_weights;
  for (std::size_t k = 0; k < packing.links.size(); ++k) {
    const Link& link = packing.links[k];
    const std::uint32_t first = new_place[link.first], second = new_place[link.second];
    if (first == kVanished || second == kVanished) continue;
    const auto [rest_x, rest_y] = rest_vector(link.direction, packing.radius);
    append_to_runs(b.runs, static_cast<std::uint32_t>(b.size()), first, second, rest_x, rest_y);
    b.first.push_back(first);
    b.second.push_back(second);
    midpoint_weights.push_back(std::max(weights.midpoints[k], weights.floor));
  }
  b.finish();
  for (std::uint32_t k = 0; k < b.size(); ++k) b.set_weight(k, midpoint_weights[k]);
  return b;
}

void weigh_particles(const Bonds& bonds, const SampledWeights& weights, double cell_mass, double radius,
                     Particles& p) {
  std::vector<std::uint32_t> bond_count(p.size(), 0);
  for (std::size_t k = 0; k < bonds.size(); ++k)
    for (const std::uint32_t i : {bonds.first[k], bonds.second[k]}) {
      p.weight[i] += bonds.weight[k];
      ++bond_count[i];
    }
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.weight[i] =
        bond_count[i] > 0 ? p.weight[i] / bond_count[i] : std::max(weights.centres[p.id[i]], weights.floor);
    p.mass.push_back(p.weight[i] * cell_mass);
    p.inertia.push_back(p.mass[i] * radius * radius / 2);
    p.inverse_mass.push_back(1 / p.mass[i]);
    p.inverse_inertia.push_back(1 / p.inertia[i]);
  }
}

}  // namespace

void Bonds::finish() {
  weight.assign(size(), 1.0);
  intact.assign(size(), 1.0);
  normal_force.assign(size(), 0.0);
  shear_force.assign(size(), 0.0);
  state.assign(size(), BondState::kIntact);
  marked_.assign(size() / kGroup + 1, false);
}

bool Bonds::plain(const Run& run) const {
  const auto last = (run.begin + run.count - 1) / kGroup;
  for (auto group = run.begin / kGroup; group <= last; ++group)
    if (std::atomic_ref(marked_[group]).load(std::memory_order_relaxed)) return false;
  return true;
}

void Bonds::mark(std::uint32_t bond) {
  std::atomic_ref(marked_[bond / kGroup]).store(true, std::memory_order_relaxed);
}

void Bonds::set_weight(std::uint32_t bond, double value) {
  weight[bond] = value;
  if (value != 1) mark(bond);
}

void Bonds::break_bond(std::uint32_t bond, BondState to) {
  state[bond] = to;
  intact[bond] = 0;
  shear_force[bond] = 0;
  mark(bond);
}

SplitRuns split(std::span<const Run> runs, const std::vector<bool>& chosen) {
  SplitRuns parts;
  for (const Run& run : runs)
    protocol::for_each_range(
        run.count, [&](std::uint32_t k) { return chosen[run.first + k] || chosen[run.second + k]; },
        [&](const protocol::IndexRange& range, bool touches) {
          Run part = run;
          part.count = range.end - range.begin;
          for (auto* number : {&part.begin, &part.first, &part.second}) *number += range.begin;
          (touches ? parts.touching : parts.others).push_back(part);
        });
  return parts;
}

Assembly assemble(const Packing& packing, double cell_mass, const SampledWeights& weights) {
  std::vector<std::uint32_t> new_place;
  Assembly assembly;
  assembly.particles = keep_particles(packing, weights.centres, new_place);
  assembly.bonds = keep_bonds(packing, weights, new_place);
  weigh_particles(assembly.bonds, weights, cell_mass, packing.radius, assembly.particles);
  return assembly;
}

Assembly assemble(const Packing& packing, double cell_mass) {
  const std::vector<double> ones(std::max(packing.x.size(), packing.links.size()), 1.0);
  return assemble(packing, cell_mass, {ones, ones, 1.0});
}

}  // namespace adit::dem
