#include "dem_server/lining/use_peaks.hpp"

#include <algorithm>

namespace adit::dem {

sections::Use use_of(const Cut& cut, const SectionForces& forces) {
  if (!cut.strength) return {};
  return sections::use_of(*cut.strength, {forces.thrust, forces.moment}, forces.shear);
}

bool any_strength(std::span<const Cut> cuts) {
  return std::ranges::any_of(cuts, [](const Cut& cut) { return cut.strength != nullptr; });
}

void UsePeaks::take(std::span<const Cut> cuts, std::span<const SectionForces> forces, double time) {
  if (!any_strength(cuts)) return;
  for (auto* peaks : {&utilisation_, &shear_, &moment_ratio_}) peaks->resize(cuts.size(), {0, {}, time});
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const sections::Use now = use_of(cuts[k], forces[k]);
    const auto take = [&](double value, std::vector<Instant>& largest) {
      if (value > largest[k].value) largest[k] = {value, forces[k], time};
    };
    take(now.utilisation, utilisation_);
    take(now.shear, shear_);
    take(now.moment_ratio, moment_ratio_);
  }
}

}  // namespace adit::dem
