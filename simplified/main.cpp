// simplified: reads a scene of the whole tunnel, computes it by one of the quick models and writes the
// results.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "protocol/log/log.hpp"
#include "protocol/results/run_directory.hpp"
#include "protocol/revision.hpp"
#include "protocol/scene/command_line.hpp"
#include "protocol/scene/origin.hpp"
#include "protocol/scene/program.hpp"
#include "protocol/scene/writer.hpp"
#include "protocol/standard_streams.hpp"
#include "simplified/run.hpp"
#include "simplified/zoom/write.hpp"

namespace {

namespace fs = std::filesystem;
namespace protocol = adit::protocol;
namespace simplified = adit::simplified;

void run_scene(const protocol::SceneCommandLine& line, const protocol::SceneFile& file,
               const std::string& zoom) {
  const std::string name = adit::results::case_name(line.scene);
  const fs::path directory =
      line.out.empty() ? fs::path("runs") / name / file.scene.name() : fs::path(line.out);
  protocol::log_run(name + "/" + file.scene.name());
  simplified::check_zoom(simplified::set_up(file.scene),
                         zoom);  // before the results of an older run are removed
  const auto held = adit::results::prepare_run_directory(directory, line.scene);
  adit::results::clear_results(directory);
  std::ofstream(directory / "scene.yaml") << protocol::to_yaml(file.scene);
  simplified::run(file.scene, name, protocol::origin_of(line, file, protocol::revision()), directory, zoom);
}

void check_scene(const protocol::SceneCommandLine& line, const protocol::SceneFile& file) {
  simplified::check(file.scene);
  protocol::print(fmt::format("{} can be computed\n", line.scene));
}

}  // namespace

int main(int argc, char** argv) {
  protocol::guard_standard_streams();
  protocol::SceneCommandLine line(
      "simplified",
      "Computes a whole tunnel under an earthquake by a simplified model and writes the results.");
  std::string zoom;
  line.run->add_option(
      "--zoom", zoom,
      "also writes zoom/<place>.yaml, a coupled scene of the joint there: worst-opening, worst-moment, "
      "worst-shear or worst-strain");
  if (const auto ended = line.parse(argc, argv)) return *ended;
  return protocol::with_scene(line.scene, line.sets, [&](const protocol::SceneFile& file) {
    if (line.run->parsed())
      run_scene(line, file, zoom);
    else
      check_scene(line, file);
  });
}
