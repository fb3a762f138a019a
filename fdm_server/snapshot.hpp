// The grid's state as a piece that a viewer can draw.
#pragma once

#include <span>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/output/peaks.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "protocol/wire.pb.h"

namespace adit::fdm {

// One piece "grid" of quadrilaterals; point fields displacement_m and velocity_m_per_s (three components, z
// = 0, as viewers expect vectors; the velocity is that of half a step later), cell fields stress_Pa (xx, yy,
// xy) and weight.
void fill_snapshot(const Grid& grid, const Continuum& continuum, std::span<const double> weights,
                   wire::Snapshot& snapshot);

// Adds the peaks to that piece: at points as of every model (peak_motion.hpp), in zones peak_shear_strain,
// peak_largest_principal_stress_Pa and peak_smallest_principal_stress_Pa.
void add_peaks(const Peaks& peaks, wire::Piece& piece);

}  // namespace adit::fdm
