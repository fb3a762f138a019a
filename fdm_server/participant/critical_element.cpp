#include "fdm_server/participant/critical_element.hpp"

#include <algorithm>

#include "fdm_server/zones/critical_step.hpp"
#include "protocol/foundation/critical_step.hpp"

namespace adit::fdm {

CriticalElement critical_element(ZoneKind kind, const Grid& grid, const Ground& ground,
                                 const Structures& structures, const DampingLaw& damping,
                                 double foundation_stiffness) {
  const CriticalZone zone = critical_zone(kind, grid, ground);
  CriticalElement critical{zone.step, zone.step, "zone", zone.centre};
  if (const auto structure = structures.critical_element(); structure.step < zone.step) {
    const auto [a, b] = structure.points;
    critical = {structure.step,
                structure.step,
                structure.kind,
                {(grid.x[a] + grid.x[b]) / 2, (grid.y[a] + grid.y[b]) / 2}};
  }
  if (foundation_stiffness > 0) {
    const double density = std::ranges::min(ground.materials, {}, &Material::density).density;
    critical.static_step = foundation::critical_step(critical.static_step, foundation_stiffness / density);
    critical.name += " on its foundation";
  }
  critical.step = critical_step(damping, critical.static_step);
  if (damping.beta > 0) critical.name += " with Rayleigh damping";
  return critical;
}

std::vector<double> static_zone_steps(ZoneKind kind, const Grid& grid, const Ground& ground,
                                      double foundation_stiffness) {
  std::vector<double> steps = zone_steps(kind, grid, ground);
  for (std::size_t z = 0; z < steps.size(); ++z)
    steps[z] = foundation::critical_step(steps[z],
                                         foundation_stiffness / ground.materials[ground.of_zone[z]].density);
  return steps;
}

}  // namespace adit::fdm
