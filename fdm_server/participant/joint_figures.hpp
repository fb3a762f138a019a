// What the joints of segments did, for the summary of the run.
#pragma once

#include <span>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/peak_joints.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::fdm {

// Of each lining with segments, over its joints and since time began: lining_<name>_largest_joint_opening_m
// at either face, _largest_joint_rotation_rad by size and with its sign, both with thrust and moment of the
// joint there and then (…_thrust_at_largest_joint_opening_N, …_moment_at_…_Nm); _largest_bolt_force_N where
// there are bolts and _least_tightness where there is water. Each has its …_time_s and place. None before the
// first step.
void add_figures(const Grid& grid, std::span<const Lining> linings, const PeakJoints& peaks, wire::Bye& bye);

}  // namespace adit::fdm
