// Numbers the discs of a model so that neighbours have near numbers: blocks of consecutive discs (pairs.hpp)
// then share few pairs, and what a step reads of them lies together.
#pragma once

#include "dem_server/model/model.hpp"

namespace adit::dem {

// Along a Morton curve through square cells, in a cell in the order that they had. Springs keep their order,
// bonds ascend again.
void renumber(Model& model);

}  // namespace adit::dem
