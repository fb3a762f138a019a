#include "protocol/results/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "protocol/errors.hpp"

namespace adit::results {
namespace {

// The process that wrote its number into the file.
std::string holder(int file) {
  std::array<char, 20> digits{};
  const ssize_t count = ::pread(file, digits.data(), digits.size(), 0);
  return count > 0 ? fmt::format("process {}", std::string(digits.data(), static_cast<std::size_t>(count)))
                   : "another process";
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder)
    : file_(::open((folder / kLockFile).c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644)) {
  const auto refuse = [&](const std::string& why) {
    if (file_ >= 0) ::close(file_);
    throw protocol::UserError(
        "", fmt::format("the results' directory {} {}, or give another one by --out", folder.string(), why));
  };
  if (file_ < 0 || ::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    if (file_ >= 0 && errno == EWOULDBLOCK)
      refuse(fmt::format("is being written to by {}; wait for its end", holder(file_)));
    refuse(fmt::format("cannot be locked ({}); make it writable", std::generic_category().message(errno)));
  }
  const std::string process = std::to_string(::getpid());
  if (::ftruncate(file_, 0) != 0 ||
      ::pwrite(file_, process.data(), process.size(), 0) != static_cast<ssize_t>(process.size()))
    refuse(fmt::format("cannot be written to ({}); make room", std::generic_category().message(errno)));
}

FolderLock::FolderLock(FolderLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  [[maybe_unused]] const int told =
      ::ftruncate(file_, 0);  // nobody holds it; results are then the same in every run
  ::close(file_);
}

}  // namespace adit::results
