// Bytes as they arrive: preamble, greeting, frames and messages in parts, in pieces of any size. The first
// byte of the input is the size of the pieces; messages do not depend on it.
#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "protocol/wire/frame.hpp"
#include "protocol/wire/parts.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

// What arrives, and the fault at which it ends.
struct Heard {
  std::vector<int> contents;
  std::string fault;
  bool operator==(const Heard&) const = default;
};

class Ear {
 public:
  Ear() { decoder_.expect_greeting(true); }

  // Throws Malformed.
  void hear(std::string_view bytes, Heard& heard) {
    while (!bytes.empty()) {
      const auto space = decoder_.space();
      const std::size_t some = std::min(space.size(), bytes.size());
      std::memcpy(space.data(), bytes.data(), some);
      decoder_.arrived(some);
      bytes.remove_prefix(some);
      take(heard);
    }
  }

 private:
  void take(Heard& heard) {
    if (!greeted_) greeted_ = decoder_.take_preamble().has_value();
    while (greeted_ && decoder_.take(frame_)) {
      if (!assembly_.add(frame_, decoder_.goes_on())) continue;
      heard.contents.push_back(frame_.content_case());
      if (!frame_.has_hello()) continue;
      decoder_.expect_greeting(false);
      decoder_.set_limit(protocol::kMaxFrameBytes);
      if (frame_.hello().reads_parts()) decoder_.accept_parts(protocol::kMaxPartBytes);
    }
  }

  protocol::FrameDecoder decoder_;
  protocol::Assembly assembly_;
  bool greeted_ = false;
  wire::Frame frame_;
};

Heard hear(std::string_view bytes, std::size_t piece) {
  Ear ear;
  Heard heard;
  try {
    for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size())))
      ear.hear(bytes.substr(0, piece), heard);
  } catch (const protocol::Malformed& fault) {
    heard.fault = fault.what();
  }
  return heard;
}

const Target kFrames(
    "frames",
    [](std::string_view input) {
      if (input.empty()) return;
      const auto piece = static_cast<unsigned char>(input.front());
      input.remove_prefix(1);
      if (hear(input, input.size()) != hear(input, std::max<std::size_t>(piece, 1)))
        throw std::logic_error("the messages depend on the pieces in which they arrive");
    },
    kFrameMemory);

}  // namespace
}  // namespace adit::fuzz
