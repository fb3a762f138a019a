// The state as pieces that a viewer can draw: particles as vertices, bonds as lines.
#pragma once

#include "dem_server/particles/assembly.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::dem {

// Piece "particles": displacement_m and velocity_m_per_s (three components), spin_rad_per_s, radius_m,
// weight, id. Piece "bonds", over the same points: normal_force_N, shear_force_N (unweighted), state (0
// intact, 1 tensile crack, 2 shear crack), weight. Displacements at the last step n since
// time began, velocities of n + 1/2.
void write_snapshot(const Assembly& assembly, wire::Snapshot& snapshot);

}  // namespace adit::dem
