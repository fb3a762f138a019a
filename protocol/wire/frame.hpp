// Messages as bytes. Each end first sends a preamble, "ADIT" and the protocol version. Then it sends frames:
// the length of the payload, and the payload, which is a serialized wire::Frame. Integers have 32 bits and
// are little-endian. The highest bit of the length says that the message goes on in the next frame
// (parts.hpp). Preamble and hello stay the same in every version, so that ends of two versions can name each
// other in their errors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "protocol/messages/wire.pb.h"
#include "protocol/wire/bounds.hpp"

namespace adit::protocol {

inline constexpr std::uint32_t kProtocolVersion = 2;

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

// The bytes of a heartbeat, the frame that says that its sender is alive, and perhaps how far it is.
std::vector<std::byte> heartbeat_frame(const std::string& progress = "");

// Turns frames into bytes, one after another in the same memory.
class FrameEncoder {
 public:
  // Length and payload in one piece, valid until the next call. Throws std::length_error if the payload is
  // longer than `limit` bytes.
  std::span<const std::byte> encode(const wire::Frame& frame, std::uint64_t limit, bool goes_on = false);

 private:
  std::vector<std::byte> buffer_;
};

// Turns bytes, which arrive in pieces of any size, into frames. A length above the limit is refused, and so
// is a message that would take more memory than bounds.hpp allows. Memory grows with the bytes that have
// arrived, never with the length that was announced. Use: read into space(), say how many bytes with
// arrived(), then take() what is complete.
class FrameDecoder {
 public:
  // The longest message. Gives back the memory of longer frames that were taken.
  void set_limit(std::uint64_t bytes);

  // From now on a message may come in parts, in frames of so many bytes at most.
  void accept_parts(std::uint64_t longest_frame) { parts_ = true, longest_frame_ = longest_frame; }

  // Whether only what greets is accepted: hello, proof and error. Nothing else of a stranger is parsed.
  void expect_greeting(bool greeting) { greeting_ = greeting; }

  std::span<std::byte> space();  // never empty
  void arrived(std::size_t bytes) { end_ += bytes; }
  std::size_t buffered() const { return end_ - begin_; }

  // The peer's protocol version, once its preamble is complete. Throws ForeignPreamble.
  std::optional<std::uint32_t> take_preamble();

  // Puts the next complete frame that is not a heartbeat into `frame`, whose memory is reused if the kind is
  // the same; false if bytes are missing. Throws Malformed.
  bool take(wire::Frame& frame);
  // Whether the message of the frame taken last goes on in the next one.
  bool goes_on() const { return goes_on_; }

  // What the last heartbeat since the last frame said.
  const std::string& progress() const { return progress_; }

  // The bytes of the frame that was taken last, length included; valid until the next call of space().
  std::span<const std::byte> taken() const { return taken_; }

 private:
  std::uint64_t longest_now() const;
  void parse(std::span<const std::byte> payload, wire::Frame& frame);
  void hear_heartbeat(std::span<const std::byte> payload);

  std::vector<std::byte> buffer_ = std::vector<std::byte>(kMaxHelloBytes);
  std::size_t begin_ = 0;  // end of the bytes that were taken
  std::size_t end_ = 0;    // end of the bytes that have arrived
  std::span<const std::byte> taken_;
  std::uint64_t limit_ = kMaxHelloBytes;
  std::uint64_t longest_frame_ = kMaxFrameBytes;
  bool parts_ = false;
  bool goes_on_ = false;
  std::uint64_t before_ = 0, memory_before_ = 0;  // of the parts before, and what they take once parsed
  bool greeting_ = false;
  std::string progress_;
};

}  // namespace adit::protocol
