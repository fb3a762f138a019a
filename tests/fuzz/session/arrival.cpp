#include "tests/fuzz/session/arrival.hpp"

#include <cstring>

#include "protocol/wire/content/clean_text.hpp"
#include "protocol/wire/frame.hpp"

namespace adit::fuzz {

std::optional<wire::Frame> arrived(std::string_view payload) {
  protocol::FrameDecoder decoder;
  const auto length = static_cast<std::uint32_t>(payload.size());
  std::string bytes(reinterpret_cast<const char*>(&length), sizeof length);
  bytes += payload;
  for (std::string_view left = bytes; !left.empty();) {
    const auto space = decoder.space();
    const std::size_t some = std::min(space.size(), left.size());
    std::memcpy(space.data(), left.data(), some);
    decoder.arrived(some);
    left.remove_prefix(some);
  }
  wire::Frame frame;
  try {
    decoder.set_limit(protocol::kMaxFrameBytes);
    if (!decoder.take(frame)) return {};
  } catch (const protocol::Malformed&) {
    return {};
  }
  protocol::clean_text(frame);
  return frame;
}

}  // namespace adit::fuzz
