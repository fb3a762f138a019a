// Text that a peer wrote goes to terminals, logs and tables.
#pragma once

#include "protocol/messages/wire.pb.h"

namespace adit::protocol {

// Makes every text of a frame one line of valid UTF-8 (one_line() of protocol/text.hpp): called on each frame
// that arrives, and before an answer is sent, because a proto3 string that is not UTF-8 cannot be parsed.
// The scene of a setup is left alone, since files travel in it.
void clean_text(wire::Frame& frame);

}  // namespace adit::protocol
