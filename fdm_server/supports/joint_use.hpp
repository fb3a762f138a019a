// What a joint of segments does.
#pragma once

#include <algorithm>
#include <span>

#include "fdm_server/supports/lining.hpp"

namespace adit::fdm {

// Openings count from where the faces touch. 0 where there are no bolts, no gasket.
struct JointUse {
  double thrust, moment;                // [N], [N m], signs as in beam.hpp
  double rotation;                      // [rad], positive if the right-hand side of the path opens
  double outer_opening, inner_opening;  // at the right-hand and the left-hand face of the lining [m]
  double bolt_force;                    // of one bolt, the largest of its rows [N]
  double gasket_opening;                // [m]
  double tightness;  // pressure of the gasket over that of the water; infinite without water

  double largest_opening() const { return std::max(outer_opening, inner_opening); }
};

// Of a joint of this lining that has segments.
JointUse joint_use(const Lining& lining, const Structures& structures, const LiningJoint& joint);

// Whether any lining has segments.
bool any_segments(std::span<const Lining> linings);

}  // namespace adit::fdm
