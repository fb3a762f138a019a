// The part that both servers share: listening, and serving one run after another until SIGINT or SIGTERM.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include "protocol/participant/participant.hpp"
#include "protocol/wire/address.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::protocol {

struct ServerOptions {
  std::string program;
  Address listen{"127.0.0.1", 0};
  bool insecure = false;  // allows addresses beyond loopback
  // The coupler may itself wait for another participant. A server waits longer than the coupler, so that the
  // error names that participant and not the coupler.
  Patience patience{.answer = std::chrono::hours(1)};
};

// Prints `listening on HOST:PORT` to stdout and serves one run after another, each with a new participant. An
// error ends the run but not the server; it is sent to the client and logged. Returns the exit code when a
// signal stops the server. Throws UserError if it cannot listen.
int serve(const ServerOptions& options, const ParticipantFactory& make_participant);

// main() of a server: command line, log, exit codes. If `threads` is given, the server has the option
// --threads, which sets it before the first run; 0 takes as many threads as speed the run up.
int server_main(int argc, char** argv, std::string_view program, const ParticipantFactory& make_participant,
                std::size_t* threads = nullptr);

}  // namespace adit::protocol
