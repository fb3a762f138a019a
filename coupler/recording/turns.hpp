// What one participant of a recording was asked and what it answered, in turn.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "coupler/recording/reader.hpp"
#include "protocol/messages/wire.pb.h"
#include "protocol/wire/frame.hpp"
#include "protocol/wire/parts.hpp"

namespace adit::coupler {

// Messages from their bytes on the wire.
class MessageReader {
 public:
  MessageReader();
  // Whether the message is whole with these bytes, which are one frame or several. Throws
  // protocol::Malformed.
  bool read(std::string_view bytes, wire::Frame& message);

 private:
  protocol::FrameDecoder decoder_;
  protocol::Assembly assembly_;
};

struct Turn {
  wire::Frame request, answer;
  bool answered = false;  // else the answer means nothing
  std::string place;      // of the request in the run: "setup", "step 12 of statics", "step 0", "finish"
};

class Turns {
 public:
  // Errors are those of RecordingReader.
  Turns(const std::filesystem::path& path, std::uint16_t participant);

  // False at the end. The memory of `turn` is reused.
  bool next(Turn& turn);

  bool cut() const { return reader_.cut(); }

 private:
  bool next_entry();
  bool read(Kind kind, wire::Frame& message);
  std::string place_of(const wire::Frame& request);

  std::filesystem::path path_;
  std::uint16_t participant_;
  RecordingReader reader_;
  MessageReader messages_;
  Entry entry_;
  bool has_entry_ = false;
  std::string step_;  // reached last
};

}  // namespace adit::coupler
