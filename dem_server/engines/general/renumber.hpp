// Numbers the discs of a model so that neighbours have near numbers: blocks of consecutive discs (pairs.hpp)
// then share few pairs, and what a step reads of them lies together.
#pragma once

#include "dem_server/model/model.hpp"

namespace adit::dem {

// Strip by strip, each from below to above, so that a block of consecutive discs is about as wide as it is
// high. In a block those on its left side come first: with the lowest ones, which follow, they are those that
// earlier blocks reach, so that what a step does to them in passes of their own reads a piece of memory and
// no more. Springs keep their order, bonds ascend again.
void renumber(Model& model);

}  // namespace adit::dem
