#pragma once

#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

// Warns of interfaces whose models have other ground at one place (bridging/overlap_ground.hpp). Where only a
// grid knows its materials' places, the participants are asked for a snapshot, before their first step.
void compare_ground(Model& model);

}  // namespace adit::coupler
