#include "protocol/trust/private_file.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "protocol/errors.hpp"

namespace adit::protocol {
namespace {

// A file that systemd hands to this service alone (LoadCredential); its mode does not say so.
bool is_credential(const std::filesystem::path& file) {
  const char* folder = std::getenv("CREDENTIALS_DIRECTORY");
  return folder != nullptr && file.parent_path() == folder;
}

}  // namespace

void require_private(const std::filesystem::path& file, std::string_view what) {
  struct stat status;
  if (::stat(file.c_str(), &status) != 0)
    throw UserError("", fmt::format("cannot read {} in {}: {}", what, file.string(), std::strerror(errno)));
  if (!S_ISREG(status.st_mode))  // a pipe would be waited for
    throw UserError("", fmt::format("{}, for {}, is not a file", file.string(), what));
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0 && !is_credential(file))
    throw UserError("", fmt::format("other users may read or change {} in {}: chmod 600 {}", what,
                                    file.string(), file.string()));
}

}  // namespace adit::protocol
