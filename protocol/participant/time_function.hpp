// The factor over time of a load or a motion (scene.proto, TimeFunction).
#pragma once

#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// Value at time t [s].
double evaluate(const scene::TimeFunction& function, double t);

// Throws UserError at `path` where the function cannot be evaluated: a table with unequal columns, fewer
// than one row, or times that do not increase.
void check(const scene::TimeFunction& function, const std::string& path);

}  // namespace adit::protocol
