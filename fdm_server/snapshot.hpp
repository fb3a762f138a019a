// The grid's state as a piece that a viewer can draw.
#pragma once

#include <span>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "protocol/wire.pb.h"

namespace adit::fdm {

// One piece "grid" of quadrilaterals, without the zones of weight 0; point fields displacement_m and
// velocity_m_per_s (three components, z = 0, as viewers expect vectors; the velocity is that of half a step
// later), cell fields stress_Pa (xx, yy, xy) and weight.
void fill_snapshot(const Grid& grid, const Continuum& continuum, std::span<const double> weights,
                   wire::Snapshot& snapshot);

}  // namespace adit::fdm
