// The cost of the chain's step over its size, for `scripts/bench simplified`.
#pragma once

namespace adit::simplified {

// Prints one JSON object a size, from 100 to 100,000 bodies: {"bodies", "sweep_ns", "direct_ns",
// "difference"}; nanoseconds for each body and step of the Riccati sweep and of Eigen's sparse LDL^T.
void time_chain(long steps);

}  // namespace adit::simplified
