#include "fdm_server/solver/deformed_grid.hpp"

#include <fmt/format.h>

#include <utility>

#include "fdm_server/zones/critical_step.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {

void require_stable_shapes(ZoneKind kind, const Grid& grid, const Ground& ground, const DampingLaw& damping,
                           std::span<const double> weights, const Continuum& continuum,
                           const protocol::Step& step) {
  Grid left{grid.x, grid.y, {}};
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    left.x[i] += continuum.ux()[i];
    left.y[i] += continuum.uy()[i];
  }
  Ground own = ground.without_zones();
  for (std::size_t z = 0; z < grid.own_zones(); ++z) {
    if (weights[z] == 0) continue;
    left.zones.push_back(grid.zones[z]);
    own.add_zone(ground, z);
    if (const Corners now = corners(left, left.zones.size() - 1); !(area(now) > 0)) {
      const auto [x, y] = centroid(corners(grid, z));
      throw protocol::Unstable(fmt::format(
          "step {}: the zone that was at ({:g}, {:g}) m is turned inside out; make the zones there "
          "larger or stiffer, or end the run before",
          step.number, x, y));
    }
  }
  const Drainage drainage = step.relax ? Drainage::kDrained : Drainage::kUndrained;
  const double critical = critical_step(damping, critical_zone(kind, left, own, drainage).step);
  if (step.dt > critical)
    throw protocol::Unstable(
        fmt::format("step {}: the zones have deformed so far that the time step of {:g} s is above their "
                    "critical step, now {:g} s; reduce time.dt_factor to {:.2g} of what it is",
                    step.number, step.dt, critical, critical / step.dt));
}

}  // namespace adit::fdm
