// The state of discs as pieces that a viewer can draw.
#pragma once

#include "dem_server/engines/general/solver.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::dem {

// Piece "particles": displacement_m, velocity_m_per_s, spin_rad_per_s, radius_m, weight, id, group,
// coordination (bonds and contacts). Piece "bonds": normal_force_N, shear_force_N (unweighted, cement and
// contact), moment_Nm, state (0 intact, 1 tensile crack, 2 shear crack), weight. Piece "contacts", of what
// touches and was never joined: the forces.
// Piece "springs", where there are any: force_N.
void write_snapshot(const Solver& solver, const Model& model, wire::Snapshot& snapshot);

}  // namespace adit::dem
