// Does an overlap lie where both its models are?
#pragma once

#include <span>

#include "coupler/bridging/overlap.hpp"

namespace adit::coupler {

// What a model fills.
struct Filled {
  BoundingBox box;
  std::span<const double> samples;  // where it is: points all over it, x0 y0 x1 y1 … [m]
};

// Throws protocol::UserError, which names a place that is not covered, unless
// - both edges of a strip run through both models;
// - in the overlap the inner model is wherever the outer one is, and the other way round: both may end
//   together, at a free face of any shape;
// - a ring meets the outer model and leaves some of it;
// - in the core of a ring the inner model is wherever the outer one would be, except in holes, which it
//   surrounds.
// Gaps of 1.5 local spacings of the samples (presence.hpp) or 15 % of the overlap's width pass,
// because a packing may lack a row at either side.
void require_inside(const Overlap& overlap, const Filled& outer, const Filled& inner);

}  // namespace adit::coupler
