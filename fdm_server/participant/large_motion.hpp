// What tells that a run in small strain has left it.
#pragma once

#include <span>

#include "fdm_server/grid/grid.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::fdm {

// Warns of zones that have strained by more than a tenth, or turned by as much, under these displacements
// [m]. `weights`: 0 of zones that were taken away.
void warn_of_large_motion(const Grid& grid, std::span<const double> weights, std::span<const double> ux,
                          std::span<const double> uy, wire::Bye& bye);

}  // namespace adit::fdm
