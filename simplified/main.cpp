// simplified: reads a scene of the whole tunnel, computes it by one of the quick models and writes the
// results.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "coupler/results/run_directory.hpp"
#include "protocol/release.hpp"
#include "protocol/scene_program.hpp"
#include "protocol/scene_writer.hpp"
#include "simplified/benchmark.hpp"
#include "simplified/run.hpp"

namespace {

namespace fs = std::filesystem;
namespace protocol = adit::protocol;
namespace simplified = adit::simplified;

struct Options {
  std::string scene;
  std::vector<std::string> sets;
  std::string out;
  long steps = 200;
};

void run_scene(const Options& options, const protocol::SceneFile& file) {
  const std::string name = adit::coupler::case_name(options.scene);
  const fs::path directory =
      options.out.empty() ? fs::path("runs") / name / file.scene.name() : fs::path(options.out);
  simplified::check(file);  // before an older run's results go
  adit::coupler::prepare_run_directory(directory, options.scene);
  adit::coupler::clear_results(directory);
  std::ofstream(directory / "scene.yaml") << protocol::to_yaml(file.scene);
  simplified::run(file, name, directory);
}

void check_scene(const Options& options, const protocol::SceneFile& file) {
  simplified::check(file);
  fmt::print("{} can be computed\n", options.scene);
}

void add_common_options(CLI::App& command, Options& options) {
  command.add_option("scene", options.scene, "scene file (YAML)")->required();
  command.add_option("--set", options.sets, "path=value: replaces a field of the scene; may be repeated")
      ->take_all()
      ->expected(1);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Computes a whole tunnel under an earthquake by a simplified model and writes the results."};
  app.set_version_flag("--version", "simplified " + std::string(protocol::release()));
  app.require_subcommand(1);
  Options options;
  auto* run_command = app.add_subcommand("run", "computes a scene");
  add_common_options(*run_command, options);
  run_command->add_option("--out", options.out,
                          "directory of the results; runs/<case>/<scene name> where absent");
  auto* check_command = app.add_subcommand("check", "sets a scene up without computing it");
  add_common_options(*check_command, options);
  auto* bench_command = app.add_subcommand("bench", "times the chain's step, as lines of JSON");
  bench_command->add_option("--steps", options.steps, "steps for each size")->check(CLI::PositiveNumber);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? protocol::kSuccess : protocol::kUserError;
  }
  if (bench_command->parsed()) {
    simplified::time_chain(options.steps);
    return protocol::kSuccess;
  }
  const auto& work = run_command->parsed() ? run_scene : check_scene;
  return protocol::with_scene(options.scene, options.sets,
                              [&](const protocol::SceneFile& file) { work(options, file); });
}
