// What a cheaper way of computing the same scene would take.
#pragma once

#include "coupler/check/pace.hpp"
#include "coupler/output/schedule.hpp"
#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

// Prints the choices that would make a run shorter that takes a minute or more, each with the time that it
// would take: a model half as fine, and cells that wait (stepping/condensed_regions.hpp). What waits is
// estimated; that it can is known after statics only.
void print_savings(const Model& model, const Schedule& schedule, const Pace& pace);

}  // namespace adit::coupler
