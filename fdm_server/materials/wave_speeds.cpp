#include "fdm_server/materials/wave_speeds.hpp"

#include <algorithm>
#include <cmath>

namespace adit::fdm {

WaveSpeeds wave_speeds(const Ground& ground) {
  WaveSpeeds fastest{0, 0};
  for (std::size_t zone = 0; zone < ground.of_zone.size(); ++zone) {
    const PlaneLaw law = ground.undrained_law(zone);
    const double density = ground.material(zone).density;
    fastest.p = std::max(fastest.p, std::sqrt((law.bulk + law.shear) / density));
    fastest.s = std::max(fastest.s, std::sqrt(law.shear / density));
  }
  return fastest;
}

}  // namespace adit::fdm
