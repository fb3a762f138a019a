#pragma once

#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

// Prints what the model consists of: a table of its particles, one of its grids, one of its interfaces, and
// the engines with the reasons why they were chosen.
void print_counts(const Model& model);

}  // namespace adit::coupler
