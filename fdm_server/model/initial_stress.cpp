#include "fdm_server/model/initial_stress.hpp"

#include "protocol/ground/stated_stress.hpp"

namespace adit::fdm {

void set_initial_stress(const scene::Stress& stress, const Grid& grid, ZoneSet& zones) {
  const protocol::StatedStress stated(stress);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const auto [x, y] = centroid(corners(grid, z));
    const auto [xx, yy, xy, zz] = stated.at(x, y);
    zones.set_stress(z, {xx, yy, xy});
    if (zz) zones.set_stress_zz(z, *zz);
  }
}

}  // namespace adit::fdm
