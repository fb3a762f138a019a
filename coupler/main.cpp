// coupler: reads a scene, starts or joins the servers that it needs, runs it and writes the results.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coupler/check/check.hpp"
#include "coupler/launch.hpp"
#include "coupler/participants/remote_connection.hpp"
#include "coupler/participants/set_up.hpp"
#include "coupler/run.hpp"
#include "coupler/tunnel/expand.hpp"
#include "protocol/errors.hpp"
#include "protocol/release.hpp"
#include "protocol/results/run_directory.hpp"
#include "protocol/revision.hpp"
#include "protocol/scene/command_line.hpp"
#include "protocol/scene/hash.hpp"
#include "protocol/scene/origin.hpp"
#include "protocol/scene/program.hpp"
#include "protocol/scene/writer.hpp"
#include "protocol/wire/greeting.hpp"

namespace {

namespace fs = std::filesystem;
namespace protocol = adit::protocol;
namespace results = adit::results;
using namespace adit::coupler;

struct Options : protocol::SceneCommandLine {
  using SceneCommandLine::SceneCommandLine;
  std::string fdm, dem;              // addresses of running servers
  std::vector<std::string> servers;  // NAME=HOST:PORT of running servers, for any model
  std::optional<std::size_t> fdm_threads, dem_threads;
};

// The servers of a run, started here or running elsewhere.
struct Participants {
  std::vector<std::unique_ptr<ServerProcess>> processes;
  std::vector<Participant> participants;
  std::string versions = "coupler " + std::string(protocol::release());
};

const char* program_of(Role role) {
  return role == Role::kContinuum ? "fdm_server" : "dem_server";
}

// Refuses a continuum server for particles and the other way round. Other codes, which have names of their
// own, may replace either server.
void require_program(const std::string& found, const Member& member, const std::string& peer) {
  const std::string other = member.role == Role::kContinuum ? "dem_server" : "fdm_server";
  if (found == other)
    throw protocol::UserError("", peer + " is a " + other + "; a " + program_of(member.role) +
                                      " is needed for the " + member.name + "; exchange --fdm and --dem");
}

// The servers named on the command line, by the names of their models.
std::map<std::string, std::string> given_servers(const Options& options, const std::vector<Member>& members) {
  std::map<std::string, std::string> addresses;
  const auto give = [&](const std::string& option, const std::string& name, const std::string& address) {
    if (std::none_of(members.begin(), members.end(), [&](const Member& m) { return m.name == name; }))
      throw protocol::UserError("", option + " names a server, but the scene has no `" + name + "`");
    for (const auto& [other, taken] : addresses)
      if (taken == address)
        throw protocol::UserError("", "the servers of `" + other + "` and `" + name + "` are both " +
                                          address + "; a server takes part once");
    if (!addresses.emplace(name, address).second)
      throw protocol::UserError("", option + " names a second server for `" + name + "`; name one");
  };
  if (!options.fdm.empty()) give("--fdm", "continuum", options.fdm);
  if (!options.dem.empty()) give("--dem", "particles", options.dem);
  for (const std::string& server : options.servers) {
    const std::size_t equals = server.find('=');
    if (equals == std::string::npos)
      throw protocol::UserError("", "--server is `" + server +
                                        "`; write the model's name and the address, as in "
                                        "--server lining=localhost:4713");
    give("--server", server.substr(0, equals), server.substr(equals + 1));
  }
  return addresses;
}

Participants join(const adit::scene::Scene& scene, const Options& options, const fs::path& log_folder) {
  Participants participants;
  const std::vector<Member> wanted = members(scene);
  const auto given = given_servers(options, wanted);
  for (const Member& member : wanted) {
    const std::string program = program_of(member.role);
    protocol::Address address;
    if (const auto found = given.find(member.name); found != given.end()) {
      address = protocol::parse_address(found->second);
    } else {
      const std::string log = is_region(member) ? program + "_" + member.name : program;
      std::vector<std::string> own;
      const auto& threads = member.role == Role::kContinuum ? options.fdm_threads : options.dem_threads;
      if (threads) own = {"--threads", std::to_string(*threads)};
      participants.processes.push_back(std::make_unique<ServerProcess>(
          program, log_folder.empty() ? "/dev/null" : log_folder / (log + ".log"), std::move(own)));
      address = participants.processes.back()->address();
    }
    auto connection = protocol::connect(address, program);
    const auto hello = protocol::handshake(*connection, "coupler");
    require_program(hello.program(), member, connection->peer());
    participants.versions += ", " + hello.program() + " " + hello.release();
    Participant& participant = participants.participants.emplace_back();
    participant.member = member;
    participant.connection = std::make_unique<RemoteConnection>(std::move(connection));
  }
  return participants;
}

void run_scene(const Options& options, const protocol::SceneFile& file, const Expansion& expansion) {
  const adit::scene::Scene& scene = expansion.scene;
  const std::string name = results::case_name(options.scene);
  const fs::path directory =
      options.out.empty() ? fs::path("runs") / name / scene.name() : fs::path(options.out);
  joins(scene, members(scene));  // wrong interfaces are refused before anything is started or written
  results::prepare_run_directory(directory, options.scene);
  Participants participants = join(scene, options, directory);
  run(scene, std::move(participants.participants),
      {.case_name = name,
       .scene_hash = protocol::scene_hash(scene),
       .versions = participants.versions,
       .scene_yaml = protocol::to_yaml(scene),
       .scene_as_written = file.scene.tunnels_size() > 0 ? protocol::to_yaml(file.scene) : "",
       .notes = expansion.notes,
       .origin = protocol::origin_of(options, file, protocol::revision())},
      directory);
}

void check_scene(const Options& options, const protocol::SceneFile&, const Expansion& expansion) {
  if (!options.out.empty()) results::prepare_run_directory(options.out, options.scene);
  Participants participants = join(expansion.scene, options, {});
  for (const std::string& note : expansion.notes) fmt::print("note: {}\n", note);
  check(expansion.scene, std::move(participants.participants), protocol::to_yaml(expansion.scene),
        options.out);
  fmt::print("{} can be computed\n", options.scene);
}

void add_servers(CLI::App& command, Options& options) {
  command.add_option("--fdm", options.fdm, "HOST:PORT of a continuum server that already listens");
  command.add_option("--dem", options.dem, "HOST:PORT of a particle server that already listens");
  command.add_option(
      "--fdm-threads", options.fdm_threads,
      "threads of the continuum server that is started here [default: as many as speed it up]");
  command.add_option("--dem-threads", options.dem_threads, "the same for each particle server");
  command
      .add_option("--server", options.servers,
                  "NAME=HOST:PORT: the same for any model by its name; may be repeated")
      ->take_all()
      ->expected(1);
}

}  // namespace

int main(int argc, char** argv) {
  Options options("coupler", "Couples a continuum and a particle solver over TCP and writes the results.");
  options.check->add_option("--out", options.out,
                            "folder for the fields of the undeformed model [default: none are written]");
  for (CLI::App* command : {options.run, options.check}) add_servers(*command, options);
  if (const auto ended = options.parse(argc, argv)) return *ended;
  const auto& work = options.run->parsed() ? run_scene : check_scene;
  return protocol::with_scene(options.scene, options.sets, [&](const protocol::SceneFile& file) {
    const Expansion expansion = expand_tunnels(file.scene);
    try {
      work(options, file, expansion);
    } catch (const protocol::UserError& error) {
      throw expansion.at_tunnel(error);
    }
  });
}
