// Natural frequencies of the tunnel on its linear springs: without slip, and with the joints' tangent
// stiffness in the installed state.
#pragma once

#include <vector>

#include "simplified/beam/model/tunnel.hpp"

namespace adit::simplified::beam {

// The lowest `count` circular frequencies [rad/s], found by subspace iteration. Fixed portals do not move.
std::vector<double> frequencies(const Tunnel& tunnel, int count);

}  // namespace adit::simplified::beam
