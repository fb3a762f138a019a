#pragma once

#include "coupler/check/pace.hpp"
#include "coupler/check/volume.hpp"

namespace adit::coupler {

// Prints what the run will take: time step and what governs it, steps, frequencies, results, memory, time.
void print_expectations(const Model& model, const Schedule& schedule, const Pace& pace, const Volume& volume);

}  // namespace adit::coupler
