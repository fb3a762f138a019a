#include "protocol/server/private_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <system_error>

namespace adit::protocol {

// In /tmp, because the path of a Unix socket must be short.
PrivateFolder::PrivateFolder() {
  std::string name = fmt::format("/tmp/adit-{}-XXXXXX", ::getpid());
  if (::mkdtemp(name.data()) != nullptr) path_ = name;
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace adit::protocol
