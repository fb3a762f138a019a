// Messages that are longer than one frame may be: they travel as several messages of their kind, parts, whose
// lists follow one another (docs/protocol.md, section Bytes). No end then holds a message a second time as
// bytes.
#pragma once

#include <cstdint>
#include <functional>

#include "protocol/messages/wire.pb.h"

namespace adit::protocol {

// Calls send(part, goes_on) for each part of the message, with at most so many bytes of one list in each.
// What is no list of numbers or messages stands in the first part. The last part, which does not go on, is
// empty.
using SendPart = std::function<void(const wire::Frame& part, bool goes_on)>;
void divide(const wire::Frame& message, std::uint64_t list_bytes, const SendPart& send);

// Puts the parts that arrive together.
class Assembly {
 public:
  // Whether the message is whole with this frame, which then holds all of it. An error may come in the place
  // of any part. Throws Malformed for a part of another kind than those before.
  bool add(wire::Frame& frame, bool goes_on);

 private:
  wire::Frame whole_;
  bool open_ = false;
};

}  // namespace adit::protocol
