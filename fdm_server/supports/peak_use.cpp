#include "fdm_server/supports/peak_use.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace adit::fdm {
namespace {

void take_larger(const PeakUse::Instant& now, double SectionUse::*of, std::size_t node,
                 std::vector<PeakUse::Instant>& largest) {
  if (node == largest.size()) largest.push_back(now);
  if (std::abs(now.use.*of) > std::abs(largest[node].use.*of)) largest[node] = now;
}

}  // namespace

bool any_section(std::span<const Lining> linings) {
  return std::ranges::any_of(linings, [](const Lining& lining) { return lining.section != nullptr; });
}

void PeakUse::take(std::span<const Lining> linings, const Structures& structures, double time) {
  if (!any_section(linings)) return;
  std::size_t row = 0;
  for (const Lining& lining : linings) {
    const std::vector<SectionUse> uses = section_uses(lining, structures);
    for (std::size_t node = 0; node < uses.size(); ++node, ++row) {
      const Instant now{uses[node], time};
      take_larger(now, &SectionUse::utilisation, row, largest_.utilisation);
      take_larger(now, &SectionUse::shear, row, largest_.shear);
      take_larger(now, &SectionUse::moment_ratio, row, largest_.moment_ratio);
      take_larger(now, &SectionUse::curvature, row, largest_.curvature);
      take_larger(now, &SectionUse::steel_strain, row, largest_.steel_strain);
      take_larger(now, &SectionUse::crack_width, row, largest_.crack_width);
      take_larger(now, &SectionUse::hinge_rotation, row, largest_.hinge_rotation);
    }
  }
}

void PeakUse::exchange(std::span<const Lining> linings, state::Archive& archive) {
  std::size_t nodes = 0;
  for (const Lining& lining : linings) nodes += lining.path.points.size();
  archive.all_or_none("lining_peak_use",
                      {&largest_.utilisation, &largest_.shear, &largest_.moment_ratio, &largest_.curvature,
                       &largest_.steel_strain, &largest_.crack_width, &largest_.hinge_rotation},
                      nodes);
}

}  // namespace adit::fdm
