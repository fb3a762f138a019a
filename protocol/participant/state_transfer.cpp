#include "protocol/participant/state_transfer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "protocol/errors.hpp"

namespace adit::protocol {

void StateParts::hold(state::Parts parts) {
  parts_ = std::move(parts);
  size_ = state::size_of(parts_);
}

void StateParts::give(std::uint64_t offset, wire::State& state) {
  const std::uint64_t part = offset / state::kPartBytes;
  if (part >= parts_.size() || offset % state::kPartBytes != 0 || parts_[part].empty())
    throw RequestError("no part of the state begins at byte " + std::to_string(offset));
  state.set_size(size_);
  state.set_checksum(state::checksum(parts_[part]));
  state.set_data(std::exchange(parts_[part], {}));
}

bool StateParts::receive(const wire::Restore& part, std::uint64_t most) {
  if (part.size() > most)
    throw RequestError(fmt::format(
        "a state of {} bytes came for a model whose states have at most {}; restore a state of this model",
        part.size(), most));
  if (part.offset() == 0) parts_.clear(), size_ = part.size();
  const std::uint64_t expected = parts_.size() * state::kPartBytes;
  if (part.offset() != expected || part.size() != size_ || expected >= size_ ||
      part.data().size() != std::min<std::uint64_t>(size_ - expected, state::kPartBytes))
    throw RequestError("a part of the state came out of order, or is of another size than it must be");
  if (state::checksum(part.data()) != part.checksum())
    throw UserError("", "the state was damaged on its way: its checksum is another one; try again");
  parts_.push_back(part.data());
  return state::size_of(parts_) == size_;
}

state::Parts StateParts::take() {
  return std::exchange(parts_, {});
}

}  // namespace adit::protocol
