#include "fdm_server/model/initial_stress.hpp"

namespace adit::fdm {

void set_initial_stress(const scene::Stress& stress, const Grid& grid, ZoneSet& zones) {
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const double y = centroid(corners(grid, z))[1];
    zones.set_stress(
        z, {stress.xx() + stress.xx_per_metre() * y, stress.yy() + stress.yy_per_metre() * y, stress.xy()});
    if (stress.has_zz() || stress.has_zz_per_metre())
      zones.set_stress_zz(z, stress.zz() + stress.zz_per_metre() * y);
  }
}

}  // namespace adit::fdm
