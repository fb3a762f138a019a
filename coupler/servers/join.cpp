#include "coupler/servers/join.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "coupler/servers/remote_connection.hpp"
#include "protocol/errors.hpp"
#include "protocol/trust/secret.hpp"
#include "protocol/wire/address.hpp"
#include "protocol/wire/greeting.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

// Refuses a continuum server for particles and the other way round. Other codes, which have names of their
// own, may replace either server.
void require_program(const std::string& found, const Member& member, const std::string& peer) {
  const std::string other = member.role == Role::kContinuum ? "dem_server" : "fdm_server";
  if (found == other)
    throw UserError("", peer + " cannot compute the " + member.name + ", for which a " +
                            program_of(member.role) + " is needed; exchange --fdm and --dem");
}

// With two servers on two cores a step by Unix sockets takes 0.83 to 0.90 of one by TCP. With three, their
// ends wait awake and take the cores from each other: the whole case cavern took 116 s, and 43 s by TCP.
bool by_unix_sockets(std::size_t servers) {
  return servers <= std::thread::hardware_concurrency();
}

std::unique_ptr<ServerProcess> start(const Member& member, const ServerChoice& choice,
                                     const std::filesystem::path& log_folder, bool by_unix_socket) {
  const std::string program = program_of(member.role);
  const std::string log = is_region(member) ? program + "_" + member.name : program;
  std::vector<std::string> own;
  const auto& threads = member.role == Role::kContinuum ? choice.fdm_threads : choice.dem_threads;
  if (threads) own = {"--threads", std::to_string(*threads)};
  return std::make_unique<ServerProcess>(
      program, log_folder.empty() ? std::filesystem::path() : log_folder / (log + ".log"), by_unix_socket,
      std::move(own));
}

}  // namespace

Trust::Trust(const TrustFiles& files) {
  if (!files.secret_file.empty()) secret = protocol::read_secret(files.secret_file);
  if (!files.tls.empty()) tls.emplace(files.tls, protocol::End::kClient);
}

const char* program_of(Role role) {
  return role == Role::kContinuum ? "fdm_server" : "dem_server";
}

std::map<std::string, std::string> given_servers(const ServerChoice& choice,
                                                 const std::vector<Member>& members) {
  std::map<std::string, std::string> addresses;
  const auto give = [&](const std::string& option, const std::string& name, const std::string& address) {
    if (std::none_of(members.begin(), members.end(), [&](const Member& m) { return m.name == name; }))
      throw UserError("", option + " names a server, but the scene has no `" + name + "`");
    for (const auto& [other, taken] : addresses)
      if (taken == address)
        throw UserError("", "the servers of `" + other + "` and `" + name + "` are both " + address +
                                "; a server takes part once");
    if (!addresses.emplace(name, address).second)
      throw UserError("", option + " names a second server for `" + name + "`; name one");
  };
  if (!choice.fdm.empty()) give("--fdm", "continuum", choice.fdm);
  if (!choice.dem.empty()) give("--dem", "particles", choice.dem);
  for (const std::string& server : choice.servers) {
    const std::size_t equals = server.find('=');
    if (equals == std::string::npos)
      throw UserError("", "--server is `" + server +
                              "`; write the model's name and the address, as in "
                              "--server lining=localhost:4713");
    give("--server", server.substr(0, equals), server.substr(equals + 1));
  }
  return addresses;
}

JoinedServers join(const std::vector<Member>& members, const ServerChoice& choice,
                   const std::filesystem::path& log_folder, const Greeted& greeted) {
  JoinedServers joined;
  const Trust shared(choice.trust);
  const auto given = given_servers(choice, members);
  for (const Member& member : members) {
    const std::string program = program_of(member.role);
    std::unique_ptr<protocol::Connection> connection;
    std::string secret = shared.secret;
    if (const auto found = given.find(member.name); found != given.end()) {
      connection = protocol::connect(protocol::parse_address(found->second), program, {}, shared.tls);
    } else {
      ServerProcess& started =
          *joined.processes.emplace_back(start(member, choice, log_folder, by_unix_sockets(members.size())));
      connection = started.connect();
      secret = started.secret();
    }
    const wire::Hello& hello = joined.hellos.emplace_back(
        protocol::handshake(*connection, "coupler", protocol::End::kClient, secret));
    require_program(hello.program(), member, connection->peer());
    greeted(member, hello, *connection);
    Participant& participant = joined.participants.emplace_back();
    participant.member = member;
    participant.connection = std::make_unique<RemoteConnection>(std::move(connection));
  }
  return joined;
}

}  // namespace adit::coupler
