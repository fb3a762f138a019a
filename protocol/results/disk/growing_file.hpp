// A file that grows by whole pieces: a piece that the disk has no room for leaves nothing of itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "protocol/state/archive.hpp"

namespace adit::results {

class GrowingFile {
 public:
  enum class Begin { kAnew, kGoOn };

  // Empties the file, or creates it; or goes on with the one that is there. Errors are those of
  // write_error.hpp.
  explicit GrowingFile(std::filesystem::path path, Begin begin = Begin::kAnew);
  ~GrowingFile();
  GrowingFile(GrowingFile&& other) noexcept;
  GrowingFile& operator=(GrowingFile&&) = delete;

  // Hands the piece to the system, so that it is kept where the program is killed.
  void append(std::string_view piece);

  // The size and the checksum enter the state of a run. One that reads takes away what the file has grown by
  // since: throws protocol::UserError where it is shorter, or where what was there then is another now.
  void exchange(state::Archive& archive);

  // Waits until the disk has all of it, which then outlasts the machine.
  void flush();

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }  // [bytes]

 private:
  std::filesystem::path path_;
  int file_;
  std::uint64_t size_ = 0;
  std::uint32_t checksum_ = 0;  // CRC-32 of what this object knows to be in it
};

}  // namespace adit::results
