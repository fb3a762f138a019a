#include "protocol/server/begin_anew.hpp"

#include <fcntl.h>
#include <linux/close_range.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "protocol/errors.hpp"

namespace adit::protocol {

void begin_anew(std::vector<std::string> command, int socket) {
  command.insert(command.end(), {"--adopt", std::to_string(socket)});
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::close_range(STDERR_FILENO + 1, ~0u, CLOSE_RANGE_CLOEXEC);
  ::fcntl(socket, F_SETFD, 0);
  ::execv("/proc/self/exe", arguments.data());
  spdlog::error("cannot begin anew: {}", std::strerror(errno));
  std::_Exit(kInternalError);
}

}  // namespace adit::protocol
