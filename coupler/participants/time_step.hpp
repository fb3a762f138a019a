#pragma once

#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

// Sets the model's step, its substeps and their number, so that rows of histories.csv fall on steps and the
// last step ends on the duration, or less than a step after it where no step divides both. Adds a note where
// rows cost many steps. Throws protocol::UserError for a step above the critical
// one, and for substeps that the model cannot take.
void choose_time_step(Model& model);

// The step of a run that goes on [s], for the duration that it has now. Adds a note where a new run would
// take another one, after choose_time_step.
void keep_time_step(Model& model, double dt);

// Afterwards: says where the duration and the share of the critical step are not those stated.
void compare_time_step(Model& model);

// The largest stable step of statics in which all participants may move [s].
double critical_static_step(const Model& model);

// Statics: gives every participant a step of its own, this share of its critical one in statics, by its step
// ratio, and returns the model's [s], the smallest. The time of statics means nothing, so that each part may
// come to rest at its own pace: the same as one clock with masses that give all parts one critical step.
// Without `own_steps` all take the smallest.
double choose_static_steps(Model& model, double share, bool own_steps);

}  // namespace adit::coupler
