#include "simplified/zoom/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"
#include "protocol/scene/writer.hpp"
#include "protocol/text.hpp"
#include "simplified/scene/along_chainage.hpp"
#include "simplified/scene/liquefaction.hpp"
#include "simplified/zoom/places.hpp"
#include "simplified/zoom/plan_scene.hpp"
#include "simplified/zoom/site.hpp"
#include "simplified/zoom/window.hpp"

namespace adit::simplified {
namespace {

namespace fs = std::filesystem;
using protocol::UserError;

const std::string kWorst = "worst-";
const std::array<std::string, 4> kPlaces{"worst-opening", "worst-moment", "worst-shear", "worst-strain"};

void write_fragment(const fs::path& directory, const Place& place, const Window& window, double duration) {
  std::ofstream file(directory / (place.name + ".yaml"));
  file << fmt::format(
              "# The tunnel from {} to {} m, around the largest {} of the run, {:.4g} {} at {:g} m: the "
              "motion of both edges.\n"
              "# Not yet a scene: write one with `extends: <this file>`, a material, and models over these "
              "chainages.\n",
              window.begin.chainage, window.end.chainage, place.name, place.value, place.unit, place.chainage)
       << protocol::to_yaml(fragment(window, place.name, duration));
  write_edges(directory, place.name, window);
}

void write_plan(const fs::path& directory, const Setup& setup, const GroundField& ground,
                const Response& response, double duration, const Place& place) {
  std::vector<double> joints;
  for (const PlacedJoint& joint : setup.line.joints) joints.push_back(joint.chainage);
  const std::size_t joint = nearest(joints, place.chainage);
  const Window around = window(response.fields, joints[joint], setup.scene->zoom().width());
  const std::string name = kWorst + place.name;
  const PlanScene plan = plan_scene(setup, response, joint, around, name, duration);
  std::ofstream(directory / (name + ".yaml")) << plan.comment << protocol::to_yaml(plan.scene);
  write_edges(directory, name, around);
  write_ground_along(directory / (name + "_along.csv"), ground, setup.clock.dt, around);
  write_joint(directory / (name + "_joint.csv"), response.fields, response.courses[joint]);
}

}  // namespace

void check_zoom(const Setup& setup, const std::string& place) {
  if (place.empty()) return;
  if (std::ranges::find(kPlaces, place) == kPlaces.end())
    throw UserError("--zoom",
                    protocol::quote(place) +
                        " is no place; give worst-opening, worst-moment, worst-shear or worst-strain" +
                        protocol::did_you_mean(place, kPlaces));
  if (setup.scene->model() != scene::Simplified::BEAM)
    throw UserError("--zoom",
                    "needs the model beam, whose joints it models closely; write `model: beam`, or leave it "
                    "out: the ground at the worst places is written for every model");
  if (may_liquefy(*setup.scene))
    throw UserError(
        "--zoom",
        "writes soil springs that stay as they are, but a layer states `liquefaction`; leave it out: the "
        "ground at the worst places is written for every scene");
  if (setup.line.joints.empty())
    throw UserError("--zoom", "needs a joint to model closely, but `tunnel.joints` are missing; give them");
  if (!setup.scene->has_zoom())
    throw UserError("--zoom", "needs the width of the window; write for example `zoom: {width: 90 m}`");
}

void write_zoom(const fs::path& directory, const Setup& setup, const GroundField& ground,
                const Response& response, double duration, const std::string& wanted) {
  fs::create_directories(directory);
  for (const Place& place : largest_responses(response)) {
    write_fragment(directory, place, window(response.fields, place.chainage, setup.scene->zoom().width()),
                   duration);
    if (setup.scene->has_ground())
      write_site(directory, place.name, setup.scene->ground(),
                 site_motion(ground, setup.clock.dt, place.chainage), place.chainage);
    if (kWorst + place.name == wanted) write_plan(directory, setup, ground, response, duration, place);
  }
}

}  // namespace adit::simplified
