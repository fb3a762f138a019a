#include "simplified/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/motion/measures.hpp"
#include "protocol/release.hpp"
#include "protocol/results/summary.hpp"
#include "protocol/scene/hash.hpp"
#include "protocol/standard_streams.hpp"
#include "protocol/text.hpp"
#include "simplified/zoom/places.hpp"

namespace adit::simplified {
namespace {

using results::Summary;

void add_responses(Summary& summary, const Response& response) {
  for (const Envelope& envelope : response.envelopes) {
    const Peak top = peak(response.chainage, envelope);
    const std::string unit = envelope.unit.empty() ? "" : "_" + envelope.unit;
    summary.set("max_" + envelope.name + unit, top.value);
    summary.set("max_" + envelope.name + "_chainage_m", top.chainage);
  }
}

// The joints by the name of their group; several groups may have the same name.
void add_joints(Summary& summary, const scene::Tunnel& tunnel, const Response& response) {
  std::vector<std::string> names;
  for (const scene::Joints& group : tunnel.joints())
    if (std::ranges::find(names, group.name()) == names.end()) names.push_back(group.name());
  for (const std::string& name : names) {
    JointResponse widest{};
    int count = 0, failed = 0;
    for (const JointResponse& joint : response.joints) {
      const scene::Joints& group = tunnel.joints(static_cast<int>(joint.group));
      if (group.name() != name) continue;
      ++count;
      if (group.has_seal_limit() && joint.opening > group.seal_limit()) ++failed;
      // At least equal, so that a group whose joints never open still names a joint.
      if (joint.opening >= widest.opening) widest = joint;
    }
    summary.set(name + "_count", count);
    summary.set(name + "_max_opening_m", widest.opening);
    summary.set(name + "_max_opening_chainage_m", widest.chainage);
    summary.set(name + "_seals_failed", failed);
  }
}

void print(const scene::Scene& scene, const Setup& setup, const Response& response, double wall_s,
           const std::filesystem::path& directory) {
  using protocol::print;
  print(fmt::format("results            {}\n", directory.string()));
  for (const std::string& note : setup.motion.notes) print(fmt::format("note               {}\n", note));
  for (const Place& place : largest_responses(response))
    print(fmt::format("largest {:<10} {:.4g} {} at {:.1f} m\n", place.name, place.value, place.unit,
                      place.chainage));
  if (const Envelope* uplift = find(response, "uplift"), *pressure = find(response, "pressure_ratio");
      uplift && pressure) {
    const Peak highest = peak(response.chainage, *uplift), most = peak(response.chainage, *pressure);
    print(fmt::format("largest uplift     {:.4g} m at {:.1f} m\n", highest.value, highest.chainage));
    print(fmt::format("pressure ratio     up to {:.2g}, at {:.1f} m\n", most.value, most.chainage));
  }
  print(fmt::format("wall time          {:.2f} s for {:g} s of motion ({:.0f} times as fast)\n", wall_s,
                    scene.time().duration(), scene.time().duration() / wall_s));
}

// What was to be computed.
Summary begin_summary(const scene::Scene& scene, const std::string& case_name, const protocol::Origin& origin,
                      const Setup& setup) {
  Summary summary;
  summary.set("case", case_name);
  summary.set("scene", scene.name());
  summary.set("scene_hash", protocol::scene_hash(scene));
  summary.set("versions", "simplified " + std::string(protocol::release()));
  summary.set_origin(origin);
  summary.set("model", protocol::lower_case(scene::Simplified::Model_Name(setup.scene->model())));
  summary.set("duration_s", scene.time().duration());
  summary.set("dt_s", setup.clock.dt);
  summary.set("steps", setup.clock.steps);
  summary.set("begin_m", setup.begin);
  summary.set("end_m", setup.end);
  summary.set("apparent_velocity_m_per_s", setup.scene->excitation().incidence().apparent_velocity());
  summary.set("peak_input_acceleration_m_per_s2",
              motion::peaks(motion::beginning(setup.motion.motion, scene.time().duration())).acceleration);
  return summary;
}

}  // namespace

void summarize(const scene::Scene& scene, const std::string& case_name, const protocol::Origin& origin,
               const Setup& setup, const Response& response, double wall_s,
               const std::filesystem::path& directory) {
  Summary summary = begin_summary(scene, case_name, origin, setup);
  for (const auto& [name, value] : response.figures) summary.set(name, value);
  add_responses(summary, response);
  add_joints(summary, setup.scene->tunnel(), response);
  summary.set("notes", setup.motion.notes);
  summary.set("completed", true);
  summary.set("wall_s", wall_s);
  summary.set("model_wall_s", response.wall_s);
  summary.set("real_time_factor", scene.time().duration() / wall_s);
  summary.write(directory / "summary.json");
  print(scene, setup, response, wall_s, directory);
}

void summarize_end(const scene::Scene& scene, const std::string& case_name, const protocol::Origin& origin,
                   const Setup& setup, const std::string& error, double wall_s,
                   const std::filesystem::path& directory) {
  Summary summary = begin_summary(scene, case_name, origin, setup);
  summary.set("notes", setup.motion.notes);
  summary.set("completed", false);
  summary.set("error", error);
  summary.set("wall_s", wall_s);
  summary.write(directory / "summary.json");
}

}  // namespace adit::simplified
