#pragma once

#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

// Sets the model's step, its substeps and their number, so that rows of histories.csv fall on steps and the
// last step ends on the duration, or less than a step after it where no step divides both. Adds a note where
// rows cannot come as asked for, or cost many steps. Throws protocol::UserError for a step above the critical
// one, and for substeps that the model cannot take.
void choose_time_step(Model& model);

}  // namespace adit::coupler
