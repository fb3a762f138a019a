#pragma once

#include "coupler/check/pace.hpp"
#include "coupler/check/volume.hpp"
#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

// Prints what the model consists of: a table of its particles, one of its grids, one of its interfaces, and
// the engines with the reasons why they were chosen.
void print_counts(const Model& model);

// Prints what the run will take: time step and what governs it, steps, frequencies, results, memory, time.
void print_expectations(const Model& model, const Schedule& schedule, const Pace& pace, const Volume& volume);

}  // namespace adit::coupler
