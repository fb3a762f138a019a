// What linings and members bore, for the summary of the run.
#pragma once

#include <span>
#include <string>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/lining.hpp"
#include "fdm_server/supports/peak_forces.hpp"
#include "fdm_server/supports/peak_shapes.hpp"
#include "fdm_server/supports/peak_use.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::fdm {

// Of each lining, over its nodes and since time began: lining_<name>_largest_thrust_N and _least_thrust_N, by
// sign, and _largest_moment_Nm, by size and with its sign. Each has its …_time_s and its grid point, …_x_m
// and …_y_m, and what acted beside it there and then: lining_<name>_moment_at_largest_thrust_Nm,
// _moment_at_least_thrust_Nm, _thrust_at_largest_moment_N. Of equal ones the first node's. None before the
// first step.
// Of each lining with a section: …_largest_utilisation with …_thrust_at_largest_utilisation_N and
// …_moment_at_largest_utilisation_Nm, …_largest_shear_utilisation with …_shear_at_largest_shear_utilisation_N
// and …_thrust_at_largest_shear_utilisation_N, and …_largest_moment_ratio with …_damage_state, each with time
// and place; where it does not stay elastic …_largest_curvature_per_m, …_largest_steel_strain,
// …_largest_crack_width_m and …_largest_hinge_rotation_rad, by size.
// Members have the same, as member_<name>_….
void add_figures(const Grid& grid, const std::string& kind, std::span<const Lining> chains,
                 const PeakForces& peaks, const PeakUse& use, wire::Bye& bye);
// How far each closed lining was pushed out of shape, with …_time_s: lining_<name>_largest_ovaling_m of a
// circle, with …_angle_rad; lining_<name>_largest_racking_m of any other.
void add_figures(std::span<const Lining> linings, const PeakShapes& shapes, wire::Bye& bye);
// When members failed: member_<name>_shear_failed_time_s, _axial_failed_time_s, _crushed_time_s, and
// _failed_time_s of the first; none that did not happen.
void add_failures(const Grid& grid, std::span<const Lining> members, const Structures& structures,
                  wire::Bye& bye);

}  // namespace adit::fdm
