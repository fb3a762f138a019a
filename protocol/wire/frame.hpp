// How messages become bytes. Either end first sends a preamble, "ADIT" and the protocol version; then
// frames: the payload's length and the payload, a serialized wire::Frame. Integers are 32 bits,
// little-endian. The preamble and the hello message stay the same in every version, so that two versions can
// name each other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "protocol/messages/wire.pb.h"

namespace adit::protocol {

inline constexpr std::uint32_t kProtocolVersion = 2;
inline constexpr std::uint64_t kMaxFrameBytes = 1024u << 20;  // what we accept, as we say in hello
inline constexpr std::uint64_t kMaxHelloBytes = 64u << 10;    // what we accept before that

using Preamble = std::array<std::byte, 8>;
Preamble encode_preamble(std::uint32_t version = kProtocolVersion);

// The bytes are none of the protocol's; says which.
class Malformed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The peer's first bytes are not a preamble: it is some other program.
class ForeignPreamble : public Malformed {
 public:
  using Malformed::Malformed;
};

// The bytes of the frame that only says that its sender is alive.
std::span<const std::byte> heartbeat_frame();

// Turns frames into bytes, one after another in the same memory.
class FrameEncoder {
 public:
  // Length and payload in one piece, valid until the next call. Throws std::length_error where the payload
  // is longer than `limit` bytes.
  std::span<const std::byte> encode(const wire::Frame& frame, std::uint64_t limit);

 private:
  std::vector<std::byte> buffer_;
};

// Turns bytes, however they are cut, into frames. Trusts nothing: a length above the limit is refused, and
// memory grows with what has arrived, never with what was announced.
//   read into space(), say how much with arrived(), then take what is complete.
class FrameDecoder {
 public:
  void set_limit(std::uint64_t bytes) { limit_ = bytes; }

  std::span<std::byte> space();  // never empty
  void arrived(std::size_t bytes) { end_ += bytes; }
  std::size_t buffered() const { return end_ - begin_; }

  // The peer's protocol version, once its preamble is complete. Throws ForeignPreamble.
  std::optional<std::uint32_t> take_preamble();

  // Puts the next complete frame that is not a heartbeat into `frame`, whose memory is used again when the
  // kind is the same; false when bytes are missing. Throws Malformed.
  bool take(wire::Frame& frame);

 private:
  std::vector<std::byte> buffer_ = std::vector<std::byte>(kMaxHelloBytes);
  std::size_t begin_ = 0;  // what was taken ends here
  std::size_t end_ = 0;    // what has arrived ends here
  std::uint64_t limit_ = kMaxHelloBytes;
};

}  // namespace adit::protocol
