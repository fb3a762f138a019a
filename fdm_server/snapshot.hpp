// The state of the grid and its supports as pieces that a viewer can draw.
#pragma once

#include <span>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/structures/peak_forces.hpp"
#include "fdm_server/structures/supports.hpp"
#include "protocol/wire.pb.h"

namespace adit::fdm {

// One piece "grid" of quadrilaterals, without the zones of weight 0; point fields displacement_m and
// velocity_m_per_s (three components, z = 0, as viewers expect vectors; the velocity is that of half a step
// later), cell fields stress_Pa (xx, yy, xy) and weight.
void fill_snapshot(const Grid& grid, const Continuum& continuum, std::span<const double> weights,
                   wire::Snapshot& snapshot);

// Pieces of lines, where there are any: "linings" with point fields displacement_m, thrust_N, moment_Nm,
// shear_N and their peaks, and the lining's number as cell field lining; "bolts" with displacement_m and, of
// one bolt, cell field thrust_N.
void add_supports(const Grid& grid, const Continuum& continuum, const Supports& supports,
                  const PeakForces& peaks, wire::Snapshot& snapshot);

}  // namespace adit::fdm
