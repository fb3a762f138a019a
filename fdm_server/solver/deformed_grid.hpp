// Large strain changes the zones' shapes, and with them the largest stable time step.
#pragma once

#include <cstdint>
#include <span>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/material.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/solver/damping.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"
#include "protocol/participant/step.hpp"

namespace adit::fdm {

// Throws Unstable where a zone is turned inside out, or the time step has become larger than the critical one
// of the zones as they are now. `weights`: of the zones; those of weight 0 are gone.
void require_stable_shapes(ZoneKind kind, const Grid& grid, const Ground& ground, const DampingLaw& damping,
                           std::span<const double> weights, const Continuum& continuum,
                           const protocol::Step& step);

}  // namespace adit::fdm
