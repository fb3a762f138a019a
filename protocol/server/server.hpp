// The skeleton of both servers: listens, and serves one run after another until SIGINT or SIGTERM.
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
  // The coupler may wait for another participant; that one, not the coupler, should then be named: so wait
  // longer.
  Patience patience{.answer = std::chrono::hours(1)};
};

// Prints `listening on HOST:PORT` to stdout and serves, each run with a fresh participant. An error ends the
// run, not the server: it is sent to the client and logged. Returns the exit code once told to stop; throws
// UserError where it cannot listen.
int serve(const ServerOptions& options, const ParticipantFactory& make_participant);

// main() of a server: command line, log, exit codes. Where `threads` is given, it is set by the option
// --threads before the first run: 0 for as many as pay.
int server_main(int argc, char** argv, std::string_view program, const ParticipantFactory& make_participant,
                std::size_t* threads = nullptr);

}  // namespace adit::protocol
