#include "protocol/results/disk/reserve.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "protocol/results/disk/write_error.hpp"

namespace adit::results {
namespace {

constexpr off_t kBytes = 1 << 20;  // the longest summaries have some hundred KiB

}  // namespace

Reserve::Reserve(const std::filesystem::path& folder) : file_(folder / "reserve") {
  const int file = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw_write_error(file_, errno);
  const int error = ::posix_fallocate(file, 0, kBytes);
  ::close(file);
  if (error == 0) return;
  release();
  throw_write_error(file_, error);
}

void Reserve::release() {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace adit::results
