#pragma once

#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

// Sets the model's step, its substeps and their number, so that the last step ends on the duration. Throws
// protocol::UserError for a step above the critical one, and for substeps that the model cannot take.
void choose_time_step(Model& model);

}  // namespace adit::coupler
