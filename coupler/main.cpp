// coupler: reads a scene, starts or joins the servers that it needs, runs it and writes the results.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "coupler/launch.hpp"
#include "coupler/remote_peer.hpp"
#include "coupler/results/run_directory.hpp"
#include "coupler/run.hpp"
#include "coupler/set_up.hpp"
#include "protocol/errors.hpp"
#include "protocol/greeting.hpp"
#include "protocol/release.hpp"
#include "protocol/scene_command_line.hpp"
#include "protocol/scene_hash.hpp"
#include "protocol/scene_program.hpp"
#include "protocol/scene_writer.hpp"

namespace {

namespace fs = std::filesystem;
namespace protocol = adit::protocol;
using namespace adit::coupler;

struct Options : protocol::SceneCommandLine {
  using SceneCommandLine::SceneCommandLine;
  std::string fdm, dem;  // addresses of servers that already listen
};

// The servers of a run: started here, or running elsewhere.
struct Participants {
  std::vector<std::unique_ptr<ServerProcess>> processes;
  std::vector<Side> sides;
  std::string versions = "coupler " + std::string(protocol::release());
};

const char* program_of(Role role) {
  return role == Role::kContinuum ? "fdm_server" : "dem_server";
}

// Another code may stand in for a server under a name of its own; our other server may not.
void require_program(const std::string& found, Role role, const std::string& peer) {
  const std::string other = role == Role::kContinuum ? "dem_server" : "fdm_server";
  if (found == other)
    throw protocol::UserError("", peer + " is a " + other + "; a " + program_of(role) +
                                      " is needed for the " + to_string(role) + ", exchange --fdm and --dem");
}

// Servers named on the command line that the scene has no use for.
void require_wanted(const Options& options, const std::vector<Role>& wanted) {
  for (const Role role : {Role::kContinuum, Role::kParticles}) {
    const bool given = !(role == Role::kContinuum ? options.fdm : options.dem).empty();
    if (given && std::find(wanted.begin(), wanted.end(), role) == wanted.end())
      throw protocol::UserError("", std::string(role == Role::kContinuum ? "--fdm" : "--dem") +
                                        " names a server, but the scene has no `" + to_string(role) + "`");
  }
  if (!options.fdm.empty() && options.fdm == options.dem)
    throw protocol::UserError("", "--fdm and --dem are both " + options.fdm + "; a server takes part once");
}

Participants join(const adit::scene::Scene& scene, const Options& options, const fs::path& log_folder) {
  Participants participants;
  require_wanted(options, roles(scene));
  for (const Role role : roles(scene)) {
    const std::string program = program_of(role);
    const std::string& given = role == Role::kContinuum ? options.fdm : options.dem;
    protocol::Address address;
    if (given.empty()) {
      participants.processes.push_back(std::make_unique<ServerProcess>(
          program, log_folder.empty() ? "/dev/null" : log_folder / (program + ".log")));
      address = participants.processes.back()->address();
    } else {
      address = protocol::parse_address(given);
    }
    auto connection = protocol::connect(address, program);
    const auto hello = protocol::handshake(*connection, "coupler");
    require_program(hello.program(), role, connection->peer());
    participants.versions += ", " + hello.program() + " " + hello.release();
    Side& side = participants.sides.emplace_back();
    side.role = role;
    side.peer = std::make_unique<RemotePeer>(std::move(connection));
  }
  return participants;
}

void run_scene(const Options& options, const protocol::SceneFile& file) {
  const std::string name = case_name(options.scene);
  const fs::path directory =
      options.out.empty() ? fs::path("runs") / name / file.scene.name() : fs::path(options.out);
  roles(file.scene);
  prepare_run_directory(directory, options.scene);
  Participants participants = join(file.scene, options, directory);
  run(file.scene, std::move(participants.sides),
      {.case_name = name,
       .scene_hash = protocol::scene_hash(file.scene),
       .versions = participants.versions,
       .scene_yaml = protocol::to_yaml(file.scene)},
      directory);
}

void check_scene(const Options& options, const protocol::SceneFile& file) {
  Participants participants = join(file.scene, options, {});
  check(file.scene, std::move(participants.sides));
  fmt::print("{} can be computed\n", options.scene);
}

void add_servers(CLI::App& command, Options& options) {
  command.add_option("--fdm", options.fdm, "HOST:PORT of a continuum server that already listens");
  command.add_option("--dem", options.dem, "HOST:PORT of a particle server that already listens");
}

}  // namespace

int main(int argc, char** argv) {
  Options options("coupler", "Couples a continuum and a particle solver over TCP and writes the results.");
  for (CLI::App* command : {options.run, options.check}) add_servers(*command, options);
  if (const auto ended = options.parse(argc, argv)) return *ended;
  const auto& work = options.run->parsed() ? run_scene : check_scene;
  return protocol::with_scene(options.scene, options.sets,
                              [&](const protocol::SceneFile& file) { work(options, file); });
}
