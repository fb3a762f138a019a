// The figures of dowels between rings.
#pragma once

#include <span>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/lining.hpp"
#include "fdm_server/supports/peak_dowels.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::fdm {

// Of each ring with dowels to the one beside it: the largest force of one dowel, and the largest offset of
// the rings there, with their times and places.
void add_figures(const Grid& grid, std::span<const Lining> linings, const PeakDowels& peaks, wire::Bye& bye);

}  // namespace adit::fdm
