// What is likely to go wrong, as the set-up shows it: the same list for a check and for a run.
#pragma once

#include <string>
#include <vector>

#include "coupler/check/pace.hpp"

namespace adit::coupler {

std::vector<std::string> warnings_before(const Model& model);

// Prints the notes and these warnings; and that the first steps failed, which ends a run instead.
void print_notes_and_warnings(const Model& model, const Pace& pace);

}  // namespace adit::coupler
