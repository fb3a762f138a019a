// Does an overlap lie where both its models are?
#pragma once

#include "coupler/bridging/overlap.hpp"

namespace adit::coupler {

// `outer`, `inner`: what the two models fill. Throws protocol::UserError unless
// - both edges of a strip run through both models, and these fill the same cross-section along it;
// - a ring meets the outer model, the inner one fills it and its core wherever the outer one is, and the
//   outer one is wherever the inner one fills the ring. So a ring may stick out where both models end.
// A packing may lack a row at either side: gaps up to 15 % (of the cross-section, of the ring's width) pass.
void require_inside(const Overlap& overlap, const BoundingBox& outer, const BoundingBox& inner);

}  // namespace adit::coupler
