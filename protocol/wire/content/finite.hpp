// Every number of the conversation is finite, except where wire.proto says otherwise. Both ends look at what
// arrives, so that the end that sent a wrong number is named and not the one that computed with it.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "protocol/messages/wire.pb.h"

namespace adit::protocol {

bool all_finite(std::span<const double> values);

// The first number of the message that is neither finite nor excepted: "predicted.energies.kinetic is nan".
// Nothing where all are. The scene of `setup` has rules of its own (check_rules.hpp).
std::optional<std::string> first_not_finite(const wire::Frame& frame);

}  // namespace adit::protocol
