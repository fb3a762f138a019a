#include "coupler/variants/variants.hpp"

#include <google/protobuf/message.h>
#include <spdlog/fmt/fmt.h>

#include <istream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "coupler/checkpoint/same_statics.hpp"
#include "coupler/participants/members.hpp"
#include "coupler/tunnel/expand.hpp"
#include "protocol/errors.hpp"
#include "protocol/motion/excitation/ground_motion.hpp"
#include "protocol/motion/measures.hpp"
#include "protocol/motion/spectra/response.hpp"
#include "protocol/scene/attached_files.hpp"
#include "protocol/scene/fields/path.hpp"
#include "protocol/scene/hash.hpp"
#include "protocol/scene/reader.hpp"

namespace adit::coupler {
namespace {

using google::protobuf::Message;
using json = nlohmann::ordered_json;  // values replace one another in the order in which they are given

constexpr double kDamping = 0.05;  // of the oscillators

// The message at a path; null if nothing is given there.
const Message* message_at(const Message& root, std::string_view path) {
  const auto steps = protocol::parse_path(path);
  const Message* at = steps && !steps->empty() ? &root : nullptr;
  for (const auto& [name, index] : steps.value_or(std::vector<protocol::PathStep>{})) {
    const auto* field = at ? at->GetDescriptor()->FindFieldByName(name) : nullptr;
    if (!field || field->cpp_type() != google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE) return nullptr;
    const auto& reflection = *at->GetReflection();
    if (field->is_repeated() != index.has_value()) return nullptr;
    if (index && *index >= static_cast<std::size_t>(reflection.FieldSize(*at, field))) return nullptr;
    if (!index && !reflection.HasField(*at, field)) return nullptr;
    at = index ? &reflection.GetRepeatedMessage(*at, field, static_cast<int>(*index))
               : &reflection.GetMessage(*at, field);
  }
  return at;
}

// Where the motion of a scene stands: below the first base or excitation that has one.
std::string key_of_motion(const scene::Scene& scene) {
  if (scene.simplified().excitation().has_motion()) return "simplified.excitation.motion";
  if (scene.continuum().base().has_acceleration()) return "continuum.base.acceleration";
  for (int i = 0; i < scene.regions_size(); ++i)
    if (scene.regions(i).continuum().base().has_acceleration())
      return fmt::format("regions[{}].continuum.base.acceleration", i);
  throw protocol::UserError("",
                            "the scene has no ground motion that a study could replace; give "
                            "continuum.base.acceleration, or name another one by motions.key");
}

json measures_of(const scene::Scene& scene, const Measured& measured) {
  const std::string key = measured.key.empty() ? key_of_motion(scene) : measured.key;
  const auto* motion = dynamic_cast<const scene::GroundMotion*>(message_at(scene, key));
  if (!motion)
    throw protocol::UserError("", key +
                                      " is no ground motion of the scene; name the key of one, such as "
                                      "continuum.base.acceleration");
  const motion::Motion acting = motion::ground_motion(*motion, key, scene.time().duration()).acting();
  const motion::Peaks peaks = motion::peaks(acting);
  json found{{"key", key},
             {"pga", peaks.acceleration},
             {"pgv", peaks.velocity},
             {"pgd", peaks.displacement},
             {"arias", motion::arias_intensity(acting)},
             {"cav", motion::cumulative_absolute_velocity(acting)}};
  if (!measured.periods.empty())
    found["sa"] = motion::response_spectrum(acting, measured.periods, kDamping).pseudo_acceleration;
  return found;
}

std::vector<protocol::Override> overrides_of(const std::string& line) {
  const json given = json::parse(line, nullptr, false);
  if (!given.is_object())
    throw protocol::UserError(
        "", "`" + line.substr(0, 100) + "` is no object of JSON, such as {\"time.duration\": \"20 s\"}");
  std::vector<std::string> sets;
  for (const auto& [key, value] : given.items()) {
    if (!value.is_string()) throw protocol::UserError("", "the value of " + key + " is no text");
    sets.push_back(key + "=" + value.get<std::string>());
  }
  return protocol::parse_overrides(sets);
}

json variant(const std::string& scene, const Measured& measured, const std::string& line) {
  const auto overrides = overrides_of(line);
  protocol::SceneFile file;
  try {
    file = protocol::read_scene(scene, overrides);
    protocol::attach_files(file);
    const Expansion expansion = expand_tunnels(file.scene);
    if (!file.scene.has_simplified()) joins(expansion.scene, members(expansion.scene));
    json told{{"hash", protocol::scene_hash(file.scene)}, {"statics", statics_hash(file.scene)}};
    if (measured.asked) told["motion"] = measures_of(file.scene, measured);
    return told;
  } catch (const protocol::UserError& error) {
    return {{"error", protocol::describe(file, error)}};
  }
}

}  // namespace

void tell_variants(const std::string& scene, const Measured& measured, std::istream& in, std::ostream& out) {
  for (std::string line; std::getline(in, line);)
    out << variant(scene, measured, line).dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
}

}  // namespace adit::coupler
