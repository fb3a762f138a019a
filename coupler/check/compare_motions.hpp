#pragma once

#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

// Says where the largest acceleration that acts on a base is not the `peak` that is stated for its motion.
void compare_motions(Model& model);

}  // namespace adit::coupler
