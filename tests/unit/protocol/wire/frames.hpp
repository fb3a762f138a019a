// Frames, and what feeds a decoder with them, for the tests of the wire.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "protocol/wire/frame.hpp"

namespace adit::protocol {

inline wire::Frame predicted(std::uint64_t step, int values) {
  wire::Frame frame;
  auto& answer = *frame.mutable_predicted();
  answer.set_step(step);
  for (int i = 0; i < values; ++i) answer.add_velocities(0.1 * i);
  return frame;
}

// The bytes arrive in pieces that fit the decoder's space.
inline void feed(FrameDecoder& decoder, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const auto space = decoder.space();
    const std::size_t count = std::min(space.size(), bytes.size());
    std::memcpy(space.data(), bytes.data(), count);
    decoder.arrived(count);
    bytes = bytes.subspan(count);
  }
}

}  // namespace adit::protocol
