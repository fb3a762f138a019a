#include "fdm_server/supports/peak_forces.hpp"

#include <cstddef>

namespace adit::fdm {
namespace {

using Instant = PeakForces::Instant;

void take_node(const Instant& now, double Instant::*force, std::size_t node, PeakForces::Extremes& extremes) {
  auto& [largest, least] = extremes;
  if (node == largest.size()) {
    largest.push_back(now);
    least.push_back(now);
  }
  if (now.*force > largest[node].*force) largest[node] = now;
  if (now.*force < least[node].*force) least[node] = now;
}

}  // namespace

void PeakForces::take(std::span<const Lining> linings, const Structures& structures, double time) {
  std::size_t row = 0;
  for (const Lining& lining : linings)
    for (std::size_t node = 0; node < lining.path.points.size(); ++node, ++row) {
      const auto [forces, count] = all_forces_at(lining, structures, node);
      for (std::size_t side = 0; side < count; ++side) {
        const auto [thrust, moment, shear] = forces[side];
        const Instant now{thrust, moment, shear, time};
        take_node(now, &Instant::thrust, row, thrust_);
        take_node(now, &Instant::moment, row, moment_);
        take_node(now, &Instant::shear, row, shear_);
      }
    }
}

void PeakForces::exchange(std::span<const Lining> linings, state::Archive& archive) {
  std::size_t nodes = 0;
  for (const Lining& lining : linings) nodes += lining.path.points.size();
  archive.all_or_none(
      "lining_peaks",
      {&thrust_.largest, &thrust_.least, &moment_.largest, &moment_.least, &shear_.largest, &shear_.least},
      nodes);
}

}  // namespace adit::fdm
