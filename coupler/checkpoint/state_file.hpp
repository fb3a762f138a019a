// A state in a file: its parts one after another, and their checksums in the manifest.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "coupler/checkpoint/manifest.hpp"
#include "protocol/results/disk/growing_file.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

class StateWriter {
 public:
  StateWriter(const std::filesystem::path& folder, std::string name, std::string format);
  // Errors are those of write_error.hpp.
  void append(std::string_view part, std::uint32_t checksum);
  // To be called once, after the last part: it lies on the disk.
  StateFile close();

 private:
  results::GrowingFile file_;
  StateFile told_;
};

// Gives the parts one after another, so that a large state never lies in memory as a whole. Every function
// throws protocol::UserError where the file is not what the manifest says.
class StateReader {
 public:
  StateReader(const std::filesystem::path& folder, const StateFile& file);
  // Puts the next part into `part`, whose memory is reused; false at the end.
  bool next(std::string& part);
  std::uint32_t checksum() const { return told_.checksums[parts_ - 1]; }  // that this part should have
  void require_right(const std::string& part) const;

 private:
  [[noreturn]] void refuse(const char* why) const;

  std::filesystem::path path_;
  StateFile told_;
  std::ifstream stream_;
  std::size_t parts_ = 0;
  std::uint64_t left_;
};

void require_whole(const std::filesystem::path& folder, const StateFile& file);
state::Parts read_state(const std::filesystem::path& folder, const StateFile& file);

}  // namespace adit::coupler
