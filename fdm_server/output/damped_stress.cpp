#include "fdm_server/output/damped_stress.hpp"

#include <algorithm>
#include <span>

namespace adit::fdm {

DampedStress::DampedStress(const DampingLaw& law, std::vector<std::uint32_t> zones)
    : law_(law), zones_(std::move(zones)), followed_(law.count() > 0 ? zones_.size() : 0) {}

void DampedStress::follow(const ZoneSet& zones, const protocol::Step& step) {
  if (step.relax) return;
  const MaxwellStep maxwell(law_, step);
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    const Stress now = zones.stress(zones_[k]);
    followed_[k].xx.follow(maxwell, now.xx);
    followed_[k].yy.follow(maxwell, now.yy);
    followed_[k].xy.follow(maxwell, now.xy);
  }
}

Stress DampedStress::of(const ZoneSet& zones, std::uint32_t zone) const {
  const Stress of_zone = zones.stress(zone);
  if (followed_.empty()) return of_zone;
  const auto& [xx, yy, xy] =
      followed_[static_cast<std::size_t>(std::ranges::lower_bound(zones_, zone) - zones_.begin())];
  return {of_zone.xx + xx.added(), of_zone.yy + yy.added(), of_zone.xy + xy.added()};
}

void DampedStress::exchange(state::Archive& archive) {
  archive("damped_stress", std::span(followed_));
}

}  // namespace adit::fdm
