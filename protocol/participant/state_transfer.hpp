// The parts of a state on their way through the conversation (wire.proto, Save and Restore).
#pragma once

#include <cstdint>

#include "protocol/messages/wire.pb.h"
#include "protocol/state/archive.hpp"

namespace adit::protocol {

class StateParts {
 public:
  // Saving: keeps a whole state, of which each part is given once.
  void hold(state::Parts parts);
  void give(std::uint64_t offset, wire::State& state);

  // Restoring: whether the state is whole with this part. Throws RequestError for a part out of order, of
  // another size than it must have, or of a state of more than `most` bytes; UserError for one that was
  // damaged.
  bool receive(const wire::Restore& part, std::uint64_t most);
  state::Parts take();

 private:
  state::Parts parts_;
  std::uint64_t size_ = 0;  // of the whole state [bytes]
};

}  // namespace adit::protocol
