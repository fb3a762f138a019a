// The part that both servers share: listening, and serving one run after another until SIGINT or SIGTERM.
#pragma once

#include <csignal>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/participant/participant.hpp"
#include "protocol/trust/tls.hpp"
#include "protocol/wire/address.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::protocol {

// Ends a server that belongs to a coupler (--exit-with-parent).
inline constexpr int kOwnerSignal = SIGUSR1;

struct ServerOptions {
  std::string program;
  std::vector<std::string> computes;  // what of a scene, see Hello in wire.proto
  Address listen{"127.0.0.1", 0};
  bool insecure = false;   // allows addresses beyond loopback
  std::optional<Tls> tls;  // of clients and this server
  std::string secret;      // that clients must know; empty: anyone is served
  std::vector<int> stop_signals{SIGINT, SIGTERM};
  Patience patience = kPatienceOfServers;
  std::vector<std::string> command;  // of this process, to begin anew
  int adopt = -1;                    // the socket that the process before listened at; -1: none
  bool begins_anew = true;           // else a computation that its client left goes on to its next answer
};

// Prints `listening on HOST:PORT`, or `listening on unix:PATH`, to stdout and serves one run after another,
// each with a new participant. An error ends the run but not the server; it is sent to the client and logged.
// Returns the exit code when a signal stops the server. Throws UserError if it cannot listen.
//
// A client may leave in the middle of a packing of hours. Within a second the server then begins anew: the
// process executes its own program, which keeps its id and the listening socket and nothing else. No
// computation needs to look at the connection, and all memory is given back. A process of several that
// belong together, as under MPI, must not do so.
int serve(const ServerOptions& options, const ParticipantFactory& make_participant);

// main() of a server: command line, log, exit codes. If `threads` is given, the server has the option
// --threads, which sets it before the first run; 0 takes as many threads as speed the run up. `begins_anew`:
// see serve().
int server_main(int argc, char** argv, std::string_view program, std::vector<std::string> computes,
                const ParticipantFactory& make_participant, std::size_t* threads = nullptr,
                const Patience& patience = kPatienceOfServers, bool begins_anew = true);

}  // namespace adit::protocol
