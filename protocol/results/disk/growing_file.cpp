#include "protocol/results/disk/growing_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/results/disk/write_error.hpp"

namespace adit::results {
namespace {

// Of the first bytes of a file.
std::uint32_t checksum_of(const std::filesystem::path& path, std::uint64_t size) {
  std::ifstream stream(path, std::ios::binary);
  std::array<char, 1 << 16> piece;
  std::uint32_t checksum = 0;
  while (size > 0) {
    stream.read(piece.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(size, piece.size())));
    const auto count = static_cast<std::size_t>(stream.gcount());
    if (count == 0) break;
    checksum = state::checksum({piece.data(), count}, checksum);
    size -= count;
  }
  return checksum;
}

}  // namespace

// Without O_NONBLOCK a pipe in its place would be waited for.
GrowingFile::GrowingFile(std::filesystem::path path, Begin begin)
    : path_(std::move(path)),
      file_(::open(path_.c_str(),
                   O_WRONLY | O_CLOEXEC | O_NONBLOCK | (begin == Begin::kAnew ? O_CREAT | O_TRUNC : 0),
                   0666)) {
  if (file_ < 0 && errno == ENOENT && begin == Begin::kGoOn)
    throw protocol::UserError(
        "", path_.string() + " is missing, with which the run would go on; begin again by coupler run");
  if (file_ < 0) throw_write_error(path_, errno);
  if (begin == Begin::kGoOn) size_ = std::filesystem::file_size(path_);
}

GrowingFile::GrowingFile(GrowingFile&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      size_(other.size_),
      checksum_(other.checksum_) {}

GrowingFile::~GrowingFile() {
  if (file_ >= 0) ::close(file_);
}

void GrowingFile::exchange(state::Archive& archive) {
  const std::uint64_t found = size_;
  archive("file_size", size_);
  archive("file_checksum", checksum_);
  if (!archive.reads()) return;
  if (found < size_)
    throw protocol::UserError(
        "", path_.string() + " is shorter than it was at the checkpoint; begin again by coupler run");
  if (checksum_of(path_, size_) != checksum_)
    throw protocol::UserError(
        "", path_.string() +
                " is not what the run wrote until the checkpoint; restore it, or begin again by coupler run");
  if (::ftruncate(file_, static_cast<off_t>(size_)) != 0) throw_write_error(path_, errno);
}

void GrowingFile::flush() {
  if (::fdatasync(file_) != 0) throw_write_error(path_, errno);
}

void GrowingFile::append(std::string_view piece) {
  for (std::size_t done = 0; done < piece.size();) {
    const ssize_t written =
        ::pwrite(file_, piece.data() + done, piece.size() - done, static_cast<off_t>(size_ + done));
    if (written >= 0) {
      done += static_cast<std::size_t>(written);
      continue;
    }
    if (errno == EINTR) continue;
    const int error = errno;
    [[maybe_unused]] const int cut = ::ftruncate(file_, static_cast<off_t>(size_));
    throw_write_error(path_, error);
  }
  size_ += piece.size();
  checksum_ = state::checksum(piece, checksum_);
}

}  // namespace adit::results
