#include "fdm_server/participant/critical_element.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdm_server/zones/critical_step.hpp"
#include "protocol/foundation/critical_step.hpp"

namespace adit::fdm {
namespace {

std::string name_of(const DampingLaw& damping) {
  constexpr const char* kNames[] = {"", " with Rayleigh damping", " with Maxwell damping"};
  return kNames[std::min<std::size_t>(damping.count(), 2)];
}

// Of contacts that move explicitly between the points of zones and linings, wherever these stand.
Contacts::Stiffest stiffest_contact(const Grid& grid, const Ground& ground, const Supports& supports,
                                    const std::vector<bool>& known_early) {
  if (supports.contacts.empty()) return {};
  auto masses = lumped_masses(grid, std::vector<double>(grid.zones.size(), 1.0), zone_densities(ground));
  supports.structures.add_masses(masses, std::numeric_limits<std::uint32_t>::max());
  return supports.contacts.stiffest(masses, known_early);
}

}  // namespace

CriticalElement critical_element(ZoneKind kind, const Grid& grid, const Ground& ground,
                                 const Supports& supports, const KnownEarly& known_early,
                                 const DampingLaw& damping, double foundation_stiffness) {
  const Structures& structures = supports.structures;
  const auto on_foundation = [&](double step) {
    if (foundation_stiffness == 0) return step;
    const double density = std::ranges::min(ground.materials, {}, &Material::density).density;
    return foundation::critical_step(step, foundation_stiffness / density);
  };
  const CriticalZone zone = critical_zone(kind, grid, ground);
  const auto structure = structures.critical_element(known_early.of_structures);
  const double zone_step = on_foundation(zone.step), structure_step = on_foundation(structure.step);
  const double drained_step = ground.any_wet()
                                  ? on_foundation(critical_zone(kind, grid, ground, Drainage::kDrained).step)
                                  : zone_step;
  const double damped_zone_step = critical_step(damping, zone_step),
               static_step = std::min(on_foundation(structures.critical_step()), drained_step);
  const std::string where = foundation_stiffness > 0 ? " on its foundation" : "";
  const auto contact = stiffest_contact(grid, ground, supports, known_early.of_contacts);
  if (contact.square > 0) {
    // No eigenvalue of a sum is above the sum of the largest ones (Weyl).
    const double element_step = std::min(damped_zone_step, structure_step);
    return {2 / std::sqrt(4 / (element_step * element_step) + contact.square),
            static_step,
            "zone with an interface at a boundary",
            {grid.x[contact.point], grid.y[contact.point]}};
  }
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
  std::vector<double> steps = zone_steps(kind, grid, ground, Drainage::kDrained);
  for (std::size_t z = 0; z < steps.size(); ++z)
    steps[z] = foundation::critical_step(steps[z],
                                         foundation_stiffness / ground.materials[ground.of_zone[z]].density);
  return steps;
}

}  // namespace adit::fdm
