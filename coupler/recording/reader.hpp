// Reads a recording (format.hpp) from its beginning to its end.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "coupler/recording/format.hpp"

namespace adit::coupler {

struct Entry {
  std::chrono::nanoseconds time{};
  std::uint16_t participant = 0;
  Kind kind = Kind::kParticipant;
  std::string content;
};

class RecordingReader {
 public:
  // Reads who takes part. Throws protocol::UserError where the file cannot be read, is no recording, or is
  // one of another version.
  explicit RecordingReader(const std::filesystem::path& path);

  // Puts the next request or answer into `entry`, whose memory is reused; false at the end. Throws
  // protocol::UserError where the file is damaged.
  bool next(Entry& entry);

  const std::vector<Speaker>& speakers() const { return speakers_; }
  // The end of the file is that of an entry that was cut: the run was killed.
  bool cut() const { return cut_; }

 private:
  bool read(Entry& entry);
  void introduce(const Entry& entry);
  [[noreturn]] void refuse(const std::string& why) const;

  std::filesystem::path path_;
  std::ifstream stream_;
  std::uint64_t size_ = 0, at_ = 0;  // of the file, of the next entry [bytes]
  bool cut_ = false;
  std::vector<Speaker> speakers_;
  Entry first_;  // after those that introduce
  bool has_first_ = false;
};

}  // namespace adit::coupler
