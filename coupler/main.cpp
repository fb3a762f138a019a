// coupler: reads a scene, starts or joins the servers that it needs, runs it and writes the results.
#include <spdlog/fmt/fmt.h>

#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coupler/check/check.hpp"
#include "coupler/checkpoint/checkpoints.hpp"
#include "coupler/checkpoint/same_statics.hpp"
#include "coupler/doctor/doctor.hpp"
#include "coupler/participants/set_up.hpp"
#include "coupler/recording/diff.hpp"
#include "coupler/recording/replay.hpp"
#include "coupler/recording/writer.hpp"
#include "coupler/run.hpp"
#include "coupler/servers/join.hpp"
#include "coupler/tunnel/expand.hpp"
#include "coupler/variants/variants.hpp"
#include "protocol/errors.hpp"
#include "protocol/release.hpp"
#include "protocol/results/run_directory.hpp"
#include "protocol/revision.hpp"
#include "protocol/scene/attached_files.hpp"
#include "protocol/scene/command_line.hpp"
#include "protocol/scene/fields/computed.hpp"
#include "protocol/scene/hash.hpp"
#include "protocol/scene/origin.hpp"
#include "protocol/scene/program.hpp"
#include "protocol/scene/study.hpp"
#include "protocol/scene/writer.hpp"
#include "protocol/standard_streams.hpp"
#include "protocol/threads/most_threads.hpp"
#include "protocol/wire/connection.hpp"

namespace {

namespace fs = std::filesystem;
namespace protocol = adit::protocol;
namespace results = adit::results;
using namespace adit::coupler;

struct Options : protocol::SceneCommandLine {
  using SceneCommandLine::SceneCommandLine;
  ServerChoice servers;
  bool which = false;     // asks for the program that computes the scene
  bool print = false;     // asks for the scene as it was read
  std::string from;       // folder of a run or a checkpoint, from whose state at rest the run begins
  std::string record;     // file of what is said to the servers
  std::string results;    // of the run that goes on, or one of its checkpoints
  std::string until;      // another duration for it
  std::string recording;  // that is replayed, or compared with another one
  std::string other_recording;
  std::string only;        // of its models
  Measured measured;       // of the ground motions of variants
  std::string address;     // of the server that is examined
  std::size_t points = 1;  // coupling points of the model for that
};

// The programs of a run, for its summary.
std::string versions_of(const JoinedServers& joined) {
  std::string versions = "coupler " + std::string(protocol::release());
  for (const adit::wire::Hello& hello : joined.hellos)
    versions += ", " + hello.program() + " " + hello.release();
  return versions;
}

// Nothing where no recording is asked for.
std::unique_ptr<RecordingWriter> begin_recording(const std::string& path) {
  return path.empty() ? nullptr : std::make_unique<RecordingWriter>(path);
}

// A server that does not compute the scene is refused; the conversation with another one is recorded.
Greeted greeted_for(const adit::scene::Scene& scene, RecordingWriter* recording) {
  return [&scene, recording](const Member& member, const adit::wire::Hello& hello,
                             protocol::Connection& connection) {
    protocol::require_computed(part_of(scene, member), to_string(member.role), member.path, hello.computes(),
                               hello.program());
    if (recording)
      recording->listen({member.name, member.role, hello.program(), hello.release()}, connection);
  };
}

// The folder of the results to which a checkpoint belongs; the results may be given themselves. A checkpoint
// may be given by a link, as `.` or with a slash at its end.
fs::path results_of(const fs::path& folder) {
  return fs::exists(folder / "checkpoint.json") ? fs::canonical(folder).parent_path().parent_path() : folder;
}

// The scene that was computed in a folder of results, with these overrides.
protocol::SceneFile scene_of(const fs::path& results, const std::vector<std::string>& sets = {}) {
  protocol::SceneFile file =
      protocol::read_scene((results / "scene.yaml").string(), protocol::parse_overrides(sets));
  protocol::attach_files(file);
  return file;
}

// With the servers and the trust of this run, without which another one would go on.
std::string resume_command(const ServerChoice& servers, const fs::path& directory) {
  std::string command = "coupler resume " + protocol::quoted_for_shell(directory.string());
  const auto add = [&command](const char* option, const std::string& value) {
    if (!value.empty()) command += fmt::format(" {} {}", option, protocol::quoted_for_shell(value));
  };
  const auto add_threads = [&add](const char* option, const std::optional<std::size_t>& threads) {
    if (threads) add(option, std::to_string(*threads));
  };
  add("--fdm", servers.fdm);
  add("--dem", servers.dem);
  add_threads("--fdm-threads", servers.fdm_threads);
  add_threads("--dem-threads", servers.dem_threads);
  for (const std::string& server : servers.servers) add("--server", server);
  add("--tls", servers.trust.tls);
  add("--secret-file", servers.trust.secret_file);
  return command;
}

void run_scene(const Options& options, const protocol::SceneFile& file, const Expansion& expansion) {
  const adit::scene::Scene& scene = expansion.scene;
  const std::string name = results::case_name(options.scene);
  const fs::path directory =
      options.out.empty() ? fs::path("runs") / name / scene.name() : fs::path(options.out);
  const std::vector<Member> wanted = members(scene);
  joins(scene, wanted);  // wrong interfaces are refused before anything is started or written
  std::optional<From> from;
  if (!options.from.empty()) {
    require_same_statics(scene_of(results_of(options.from)).scene, scene);
    from = {read_checkpoint(options.from, true), false};
  }
  const auto held = results::prepare_run_directory(directory, options.scene);
  const auto recording = begin_recording(options.record);
  JoinedServers joined = join(wanted, options.servers, directory, greeted_for(scene, recording.get()));
  run(scene, std::move(joined.participants),
      {.case_name = name,
       .scene_hash = protocol::scene_hash(scene),
       .versions = versions_of(joined),
       .scene_yaml = protocol::to_yaml(scene),
       .scene_as_written = file.scene.tunnels_size() > 0 ? protocol::to_yaml(file.scene) : "",
       .notes = expansion.notes,
       .origin = protocol::origin_of(options, file, protocol::revision()),
       .resume_command = resume_command(options.servers, directory)},
      directory, std::move(from));
}

// Goes on with the run whose results lie in a folder.
void resume(const Options& options, const protocol::SceneFile& file) {
  const fs::path directory = results_of(options.results);
  const results::FolderLock held(directory);
  Checkpoint checkpoint = read_checkpoint(options.results);
  const Manifest& manifest = checkpoint.manifest;
  if (hash_of(file.scene) != manifest.scene_hash)
    throw protocol::UserError(
        "", (directory / "scene.yaml").string() +
                ", or a file that it names, is not what it was when the run began; restore it, "
                "or begin again by coupler run");
  const adit::scene::Scene scene =
      options.until.empty() ? file.scene : scene_of(directory, {"time.duration=" + options.until}).scene;
  if (!options.until.empty() && scene.time().duration() < manifest.time - manifest.dt)
    throw protocol::UserError(
        "", fmt::format("--until {} lies before the checkpoint at {:g} s", options.until, manifest.time));
  const auto recording = begin_recording(options.record);
  JoinedServers joined =
      join(members(scene), options.servers, directory, greeted_for(scene, recording.get()));
  const RunLabels labels{.case_name = manifest.case_name,
                         .scene_hash = protocol::scene_hash(scene),
                         .versions = versions_of(joined),
                         .scene_yaml = protocol::to_yaml(scene),
                         .scene_as_written = "",
                         .notes = manifest.notes,
                         .origin = manifest.origin,
                         .resume_command = resume_command(options.servers, directory)};
  run(scene, std::move(joined.participants), labels, directory, From{std::move(checkpoint), true});
}

void check_scene(const Options& options, const protocol::SceneFile&, const Expansion& expansion) {
  std::optional<results::FolderLock> held;
  if (!options.out.empty()) held.emplace(results::prepare_run_directory(options.out, options.scene));
  JoinedServers joined =
      join(members(expansion.scene), options.servers, {}, greeted_for(expansion.scene, nullptr));
  for (const std::string& note : expansion.notes) protocol::print(fmt::format("note: {}\n", note));
  check(expansion.scene, std::move(joined.participants), protocol::to_yaml(expansion.scene), options.out);
  protocol::print(fmt::format("{} can be computed\n", options.scene));
}

void refuse_accuracy_of_nothing(const adit::scene::Scene& scene) {
  if (scene.has_accuracy() && scene.questions_size() == 0)
    throw protocol::UserError(
        "accuracy",
        "asks for an accuracy, but of nothing; name figures of summary.json or columns of "
        "histories.csv in `questions`, such as [lining_tunnel_largest_thrust_N]");
}

void add_trust(CLI::App& command, TrustFiles& trust) {
  command.add_option("--tls", trust.tls,
                     "folder of this machine's certificate, as `adit certificates` makes it: servers that "
                     "already listen must have one of the same authority. For servers that ask for a secret, "
                     "authority.pem in it is enough");
  command.add_option("--secret-file", trust.secret_file,
                     "file whose first line is the secret of the servers that already listen");
}

void add_servers(CLI::App& command, ServerChoice& servers) {
  command.add_option("--fdm", servers.fdm,
                     "HOST:PORT, or unix:PATH, of a continuum server that already listens");
  command.add_option("--dem", servers.dem,
                     "HOST:PORT, or unix:PATH, of a particle server that already listens");
  const CLI::Range possible(std::size_t{0}, protocol::kMostThreads);
  command
      .add_option("--fdm-threads", servers.fdm_threads,
                  "threads of the continuum server that is started here [default: as many as speed it up]")
      ->check(possible);
  command.add_option("--dem-threads", servers.dem_threads, "the same for each particle server")
      ->check(possible);
  command
      .add_option("--server", servers.servers,
                  "NAME=HOST:PORT: the same for any model by its name; may be repeated")
      ->take_all()
      ->expected(1);
  add_trust(command, servers.trust);
}

// Of the case cantilever; and of an interface of a kilometre in discs of a decimetre.
constexpr std::size_t kExampleOfPoints = 140, kMostPoints = 10000;

// A command that needs no scene; its work gives the exit code.
using Command = std::pair<CLI::App*, std::function<int()>>;

std::vector<Command> add_commands_without_scene(Options& options) {
  CLI::App* replay_command = options.app.add_subcommand(
      "replay", "asks servers again what a recording says, and compares their answers bit by bit");
  replay_command->add_option("recording", options.recording, "file that --record wrote")->required();
  replay_command->add_option("--only", options.only, "model to replay [default: all, one after another]");
  add_servers(*replay_command, options.servers);
  CLI::App* diff_command =
      options.app.add_subcommand("diff", "names the first step and field in which two recordings differ");
  diff_command->add_option("a", options.recording, "file that --record wrote")->required();
  diff_command->add_option("b", options.other_recording, "another one")->required();
  CLI::App* doctor_command = options.app.add_subcommand(
      "doctor", "examines a server that listens: who it is, whether it serves, how fast it answers");
  doctor_command->add_option("address", options.address, "HOST:PORT, or unix:PATH")->required();
  doctor_command
      ->add_option("--points", options.points,
                   "coupling points of the steps that are timed, as coupler check counts them for a scene")
      ->default_val(kExampleOfPoints)
      ->check(CLI::Range(std::size_t{1}, kMostPoints));
  add_trust(*doctor_command, options.servers.trust);
  CLI::App* study_command =
      options.app.add_subcommand("study", "prints a study (adit study) as it is read, in SI units");
  study_command->add_option("study", options.scene, "file of the study (YAML)")->required();
  CLI::App* variants_command = options.app.add_subcommand(
      "variants",
      "tells for each line of standard input, an object of JSON {path: text} of values as by --set, "
      "what identifies the scene that it makes, and measures its ground motion");
  variants_command->add_option("scene", options.scene, "scene file (YAML)")->required();
  variants_command->add_flag("--motion", options.measured.asked, "measure the ground motion");
  variants_command->add_option("--key", options.measured.key,
                               "path of that motion [default: of the base, or of the excitation]");
  variants_command->add_option("--period", options.measured.periods, "of spectral accelerations [s]")
      ->check(CLI::PositiveNumber);
  return {
      {replay_command, [&] { return replay(options.recording, options.servers, options.only); }},
      {diff_command, [&] { return diff(options.recording, options.other_recording); }},
      {doctor_command,
       [&] {
         doctor(options.address, options.servers.trust, options.points);
         return int{protocol::kSuccess};
       }},
      {study_command,
       [&] {
         protocol::print(protocol::to_yaml(protocol::read_study(options.scene)));
         return int{protocol::kSuccess};
       }},
      {variants_command,
       [&] {
         tell_variants(options.scene, options.measured, std::cin, std::cout);
         return int{protocol::kSuccess};
       }},
  };
}

}  // namespace

int main(int argc, char** argv) {
  protocol::guard_standard_streams();
  Options options("coupler", "Couples a continuum and a particle solver over TCP and writes the results.");
  options.run->add_option(
      "--from", options.from,
      "folder of a run, from whose state after statics this one begins; only time, output and "
      "accelerations of a base may differ");
  options.check->add_option("--out", options.out,
                            "folder for the fields of the undeformed model [default: none are written]");
  options.check->add_flag(
      "--which", options.which,
      "print the program that computes the scene, coupler or simplified, and look no further");
  options.check->add_flag(
      "--print", options.print,
      "print the scene as it is read, with all bases and settings, in SI units, and look no further");
  CLI::App* goes_on = options.app.add_subcommand("resume", "goes on with a run that was stopped or killed");
  goes_on->add_option("results", options.results, "folder of its results, or one of its checkpoints")
      ->required();
  goes_on->add_option("--until", options.until, "its duration from now on, as in --until '20 s'");
  for (CLI::App* command : {options.run, goes_on})
    command->add_option("--record", options.record,
                        "file for all that is said to the servers and answered, which replay and diff read");
  for (CLI::App* command : {options.run, options.check, goes_on}) add_servers(*command, options.servers);
  const auto others = add_commands_without_scene(options);
  if (const auto ended = options.parse(argc, argv)) return *ended;
  for (const auto& [command, work] : others)
    if (command->parsed()) return protocol::with_errors_told(work);
  if (goes_on->parsed())
    return protocol::with_scene((results_of(options.results) / "scene.yaml").string(), {},
                                [&](const protocol::SceneFile& file) { resume(options, file); });
  const auto& work = options.run->parsed() ? run_scene : check_scene;
  return protocol::with_scene(options.scene, options.sets, [&](const protocol::SceneFile& file) {
    refuse_accuracy_of_nothing(file.scene);
    if (options.which) return protocol::print(file.scene.has_simplified() ? "simplified\n" : "coupler\n");
    if (options.print) return protocol::print(protocol::to_yaml(file.scene));
    const Expansion expansion = expand_tunnels(file.scene);
    try {
      work(options, file, expansion);
    } catch (const protocol::UserError& error) {
      throw expansion.at_tunnel(error);
    }
  });
}
