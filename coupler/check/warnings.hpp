// What is likely to go wrong, as the set-up shows it: the same list for a check and for a run.
#pragma once

#include <string>
#include <vector>

#include "coupler/check/pace.hpp"
#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

std::vector<std::string> warnings_before(const Model& model);

// Prints the notes and these warnings; and that the first steps failed, which ends a run instead.
void print_notes_and_warnings(const Model& model, const Pace& pace);

// Warns of interfaces whose models have other ground at one place (bridging/overlap_notes.hpp). Where only a
// grid knows its materials' places, the participants are asked for a snapshot, before their first step.
void compare_ground(Model& model);

// Says where the largest acceleration that acts on a base is not the `peak` that is stated for its motion.
void compare_motions(Model& model);

}  // namespace adit::coupler
