// Messages as bytes. Each end first sends a preamble, "ADIT" and the protocol version. Then it sends frames:
// the length of the payload, and the payload, which is a serialized wire::Frame. Integers have 32 bits and
// are little-endian. Preamble and hello stay the same in every version, so that ends of two versions can name
// each other in their errors.
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
inline constexpr std::uint64_t kMaxFrameBytes = 1024u << 20;  // longest frame accepted, as announced in hello
inline constexpr std::uint64_t kMaxHelloBytes = 64u << 10;  // longest frame accepted before hello has arrived

using Preamble = std::array<std::byte, 8>;
Preamble encode_preamble(std::uint32_t version = kProtocolVersion);

// The bytes do not follow the protocol; the message says how.
class Malformed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The peer's first bytes are not a preamble, so the peer is some other program.
class ForeignPreamble : public Malformed {
 public:
  using Malformed::Malformed;
};

// The bytes of a heartbeat, the frame that says only that its sender is alive.
std::span<const std::byte> heartbeat_frame();

// Turns frames into bytes, one after another in the same memory.
class FrameEncoder {
 public:
  // Length and payload in one piece, valid until the next call. Throws std::length_error if the payload is
  // longer than `limit` bytes.
  std::span<const std::byte> encode(const wire::Frame& frame, std::uint64_t limit);

 private:
  std::vector<std::byte> buffer_;
};

// Turns bytes, which arrive in pieces of any size, into frames. A length above the limit is refused, and
// memory grows with the bytes that have arrived, never with the length that was announced. Use: read into
// space(), say how many bytes with arrived(), then take() what is complete.
class FrameDecoder {
 public:
  void set_limit(std::uint64_t bytes) { limit_ = bytes; }

  std::span<std::byte> space();  // never empty
  void arrived(std::size_t bytes) { end_ += bytes; }
  std::size_t buffered() const { return end_ - begin_; }

  // The peer's protocol version, once its preamble is complete. Throws ForeignPreamble.
  std::optional<std::uint32_t> take_preamble();

  // Puts the next complete frame that is not a heartbeat into `frame`, whose memory is reused if the kind is
  // the same; false if bytes are missing. Throws Malformed.
  bool take(wire::Frame& frame);

 private:
  std::vector<std::byte> buffer_ = std::vector<std::byte>(kMaxHelloBytes);
  std::size_t begin_ = 0;  // end of the bytes that were taken
  std::size_t end_ = 0;    // end of the bytes that have arrived
  std::uint64_t limit_ = kMaxHelloBytes;
};

}  // namespace adit::protocol
