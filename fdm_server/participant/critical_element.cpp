#include "fdm_server/participant/critical_element.hpp"

#include <algorithm>

#include "fdm_server/zones/critical_step.hpp"
#include "protocol/foundation/critical_step.hpp"

namespace adit::fdm {
namespace {

std::string name_of(const DampingLaw& damping) {
  constexpr const char* kNames[] = {"", " with Rayleigh damping", " with Maxwell damping"};
  return kNames[std::min<std::size_t>(damping.count(), 2)];
}

}  // namespace

CriticalElement critical_element(ZoneKind kind, const Grid& grid, const Ground& ground,
                                 const Structures& structures, const std::vector<bool>& known_early,
                                 const DampingLaw& damping, double foundation_stiffness) {
  const auto on_foundation = [&](double step) {
    if (foundation_stiffness == 0) return step;
    const double density = std::ranges::min(ground.materials, {}, &Material::density).density;
    return foundation::critical_step(step, foundation_stiffness / density);
  };
  const CriticalZone zone = critical_zone(kind, grid, ground);
  const auto structure = structures.critical_element(known_early);
  const double zone_step = on_foundation(zone.step), structure_step = on_foundation(structure.step);
  const double damped_zone_step = critical_step(damping, zone_step),
               static_step = std::min(on_foundation(structures.critical_step()), zone_step);
  const std::string where = foundation_stiffness > 0 ? " on its foundation" : "";
  if (structure_step < damped_zone_step) {
    const auto [a, b] = structure.points;
    return {structure_step,
            static_step,
            structure.kind + where,
            {(grid.x[a] + grid.x[b]) / 2, (grid.y[a] + grid.y[b]) / 2}};
  }
  return {damped_zone_step, static_step, "zone" + where + name_of(damping), zone.centre};
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
