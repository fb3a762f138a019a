// The servers that compute the models of a scene: those that the user names, others are started here.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupler/participants/members.hpp"
#include "coupler/participants/participant.hpp"
#include "coupler/servers/launch.hpp"
#include "protocol/messages/wire.pb.h"
#include "protocol/trust/tls.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::coupler {

// How servers that already listen know this user; empty: not at all.
struct TrustFiles {
  std::string secret_file;
  std::string tls;  // folder of the certificate of this machine
};

// The same, read. The functions throw protocol::UserError where a file cannot be used.
struct Trust {
  Trust() = default;
  explicit Trust(const TrustFiles& files);

  std::string secret;
  std::optional<protocol::Tls> tls;
};

// What the command line says of servers.
struct ServerChoice {
  std::string fdm, dem;              // addresses of those that already listen
  std::vector<std::string> servers;  // NAME=HOST:PORT of the same, for any model
  TrustFiles trust;
  std::optional<std::size_t> fdm_threads, dem_threads;  // of those that are started here
};

struct JoinedServers {
  std::vector<std::unique_ptr<ServerProcess>> processes;
  std::vector<Participant> participants;
  std::vector<wire::Hello> hellos;  // of the participants
};

// Called for each connection once both ends have greeted.
using Greeted =
    std::function<void(const Member& member, const wire::Hello& hello, protocol::Connection& connection)>;

const char* program_of(Role role);

// The addresses of the servers that already listen, by the names of their models. Throws protocol::UserError
// for a name that no member has, and for a second server of one model.
std::map<std::string, std::string> given_servers(const ServerChoice& choice,
                                                 const std::vector<Member>& members);

// Connects to a server for each member. Logs of servers that are started here lie in `log_folder`; an empty
// path keeps none.
JoinedServers join(
    const std::vector<Member>& members, const ServerChoice& choice, const std::filesystem::path& log_folder,
    const Greeted& greeted = [](const Member&, const wire::Hello&, protocol::Connection&) {});

}  // namespace adit::coupler
