#include "fdm_server/materials/wave_speeds.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace adit::fdm {

WaveSpeeds wave_speeds(const Ground& ground) {
  WaveSpeeds fastest{0, 0};
  for (const std::uint32_t number : std::set(ground.of_zone.begin(), ground.of_zone.end())) {
    const Material& material = ground.materials[number];
    const PlaneLaw law = ground.plane_law(material);
    fastest.p = std::max(fastest.p, std::sqrt((law.bulk + law.shear) / material.density));
    fastest.s = std::max(fastest.s, std::sqrt(law.shear / material.density));
  }
  return fastest;
}

}  // namespace adit::fdm
