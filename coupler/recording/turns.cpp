#include "coupler/recording/turns.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "protocol/errors.hpp"

namespace adit::coupler {

MessageReader::MessageReader() {
  decoder_.set_limit(std::numeric_limits<std::uint64_t>::max());
  decoder_.accept_parts(protocol::kMaxFrameBytes);
}

bool MessageReader::read(std::string_view bytes, wire::Frame& message) {
  bool whole = false;
  while (!bytes.empty()) {
    const auto space = decoder_.space();
    const std::size_t count = std::min(space.size(), bytes.size());
    std::memcpy(space.data(), bytes.data(), count);
    decoder_.arrived(count);
    bytes.remove_prefix(count);
    while (!whole && decoder_.take(message)) whole = assembly_.add(message, decoder_.goes_on());
  }
  if (decoder_.buffered() > 0) throw protocol::Malformed("these bytes are not whole frames of one message");
  return whole;
}

Turns::Turns(const std::filesystem::path& path, std::uint16_t participant)
    : path_(path), participant_(participant), reader_(path) {
  has_entry_ = next_entry();
}

bool Turns::next(Turn& turn) {
  if (!has_entry_) return false;
  if (entry_.kind != Kind::kRequest)
    throw protocol::UserError("", path_.string() + ": it has an answer without a request");
  if (!read(Kind::kRequest, turn.request)) return false;
  turn.place = place_of(turn.request);
  turn.answered = read(Kind::kAnswer, turn.answer);
  return true;
}

bool Turns::next_entry() {
  while (reader_.next(entry_))
    if (entry_.participant == participant_) return true;
  return false;
}

// The entries of one message; false where there is none, or the recording ends before it is whole.
bool Turns::read(Kind kind, wire::Frame& message) {
  try {
    for (bool whole = false; !whole; has_entry_ = next_entry()) {
      if (!has_entry_ || entry_.kind != kind) return false;
      whole = messages_.read(entry_.content, message);
    }
    return true;
  } catch (const protocol::Malformed& fault) {
    throw protocol::UserError(
        "", fmt::format("{}: it holds a frame that cannot be read: {}", path_.string(), fault.what()));
  }
}

std::string Turns::place_of(const wire::Frame& request) {
  const std::string name = wire::Frame::descriptor()->FindFieldByNumber(request.content_case())->name();
  if (request.has_advance())
    return step_ = fmt::format("step {}{}", request.advance().step(),
                               request.advance().relax() ? " of statics" : "");
  return step_.empty() ? name : name + " after " + step_;
}

}  // namespace adit::coupler
