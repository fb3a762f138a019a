#include "fdm_server/output/damped_stress.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace adit::fdm {

DampedStress::DampedStress(const DampingLaw& law, std::vector<std::uint32_t> zones)
    : law_(law), zones_(std::move(zones)), followed_(law.count() > 0 ? zones_.size() : 0) {}

void DampedStress::follow(const ZoneSet& zones, const protocol::Step& step) {
  if (step.relax) return;
  const MaxwellStep maxwell(law_, step);
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    auto& [before, elements] = followed_[k];
    const Stress now = zones.stress(zones_[k]);
    for (std::size_t e = 0; e < kMostElements; ++e)
      for (double Stress::*part : {&Stress::xx, &Stress::yy, &Stress::xy})
        elements[e].*part = maxwell(e, elements[e].*part, now.*part - before.*part);
    before = now;
  }
}

Stress DampedStress::of(const ZoneSet& zones, std::uint32_t zone) const {
  Stress sum = zones.stress(zone);
  if (followed_.empty()) return sum;
  const auto k = std::ranges::lower_bound(zones_, zone) - zones_.begin();
  for (const Stress& element : followed_[static_cast<std::size_t>(k)].elements)
    for (double Stress::*part : {&Stress::xx, &Stress::yy, &Stress::xy}) sum.*part += element.*part;
  return sum;
}

void DampedStress::exchange(state::Archive& archive) {
  archive("damped_stress", std::span(followed_));
}

}  // namespace adit::fdm
