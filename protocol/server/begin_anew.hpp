// A server leaves a computation that nobody waits for any more.
#pragma once

#include <string>
#include <vector>

namespace adit::protocol {

// Executes the program of this process again, with the command and `--adopt SOCKET`: the process keeps its
// id, its standard streams and the listening socket, and loses all else, threads included. May be called from
// any thread. Where the system refuses, the process ends with kInternalError.
[[noreturn]] void begin_anew(std::vector<std::string> command, int socket);

}  // namespace adit::protocol
