#pragma once

#include "coupler/check/pace.hpp"

namespace adit::coupler {

// Prints the participants' notes, and a warning for what is likely to go wrong.
void print_notes_and_warnings(const Model& model, const Pace& pace);

}  // namespace adit::coupler
