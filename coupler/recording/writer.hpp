// Writes a recording (format.hpp) while a run goes on.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "coupler/recording/format.hpp"
#include "protocol/results/disk/growing_file.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::coupler {

class RecordingWriter {
 public:
  // Begins a new file, or takes the place of another recording. Throws protocol::UserError where neither can
  // be. Frames throw protocol::DiskFull where the disk has no room.
  explicit RecordingWriter(const std::filesystem::path& path);
  // Writes what is still in memory, as far as it can be.
  ~RecordingWriter();
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  // Records a participant from now on. The recording must outlive the connection's last frame.
  void listen(const Speaker& speaker, protocol::Connection& connection);

  // As listen() does for each frame: adds a participant, whose number is returned, and what was said.
  std::uint16_t introduce(const Speaker& speaker);
  void add(std::uint16_t participant, Kind kind, std::span<const std::byte> content);

 private:
  using Clock = std::chrono::steady_clock;
  void hand_over();

  Clock::time_point start_ = Clock::now();
  results::GrowingFile file_;
  std::string waiting_;  // whole entries that the file does not have yet
  std::uint16_t participants_ = 0;
};

}  // namespace adit::coupler
