// The factor over time of a load or a motion (scene.proto, TimeFunction).
#pragma once

#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// Value at time t [s] of a function that fulfils its rules (protocol/scene/fields/check_rules.hpp).
double evaluate(const scene::TimeFunction& function, double t);

// The value never changes.
bool is_steady(const scene::TimeFunction& function);

}  // namespace adit::protocol
