#include "protocol/results/disk/write_error.hpp"

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

#include "protocol/errors.hpp"

namespace adit::results {

void throw_write_error(const std::filesystem::path& file, int error) {
  const std::string reason = std::generic_category().message(error);
  const std::string what = "cannot write " + file.string() + ": " + reason;
  if (error == ENOSPC || error == EDQUOT)
    throw protocol::DiskFull(what + "; make room, or give another folder by --out");
  if (error == EFBIG) throw protocol::DiskFull(what + "; raise the limit of a file's size (ulimit -f)");
  throw protocol::UserError("", what + "; make the folder writable, or give another one by --out");
}

}  // namespace adit::results
