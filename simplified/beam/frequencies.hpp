// Natural frequencies of the tunnel on its linear springs (no slip, joints with their tangent in the
// installed state).
#pragma once

#include <vector>

#include "simplified/beam/model/tunnel.hpp"

namespace adit::simplified::beam {

// The lowest `count` circular frequencies [rad/s], by subspace iteration. Fixed portals stand still.
std::vector<double> frequencies(const Tunnel& tunnel, int count);

}  // namespace adit::simplified::beam
