#pragma once

#include <array>
#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/damping_law.hpp"
#include "fdm_server/materials/material.hpp"
#include "fdm_server/supports/supports.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"

namespace adit::fdm {

// What governs the critical time step: its name, such as "zone", "beam" or "zone with Rayleigh damping", and
// its middle [m]. Springs of a foundation of this stiffness per area k [N/m^3] raise the omega^2 of an
// element by k A over its mass, at most k / rho of the lightest ground.
struct CriticalElement {
  double step;         // [s]
  double static_step;  // the same in statics, where no damping acts, structures do not average and contacts
                       // have masses of their own
  std::string name;
  std::array<double, 2> place;
};

// In time only structures and contacts that touch one of these points count (solver/continuum.hpp).
struct KnownEarly {
  std::vector<bool> of_structures, of_contacts;
};
CriticalElement critical_element(ZoneKind kind, const Grid& grid, const Ground& ground,
                                 const Supports& supports, const KnownEarly& known_early,
                                 const DampingLaw& damping, double foundation_stiffness);

// The critical step of every zone in statics [s], on such a foundation.
std::vector<double> static_zone_steps(ZoneKind kind, const Grid& grid, const Ground& ground,
                                      double foundation_stiffness);

}  // namespace adit::fdm
