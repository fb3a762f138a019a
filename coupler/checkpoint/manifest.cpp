#include "coupler/checkpoint/manifest.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "protocol/errors.hpp"
#include "protocol/results/atomic_file.hpp"
#include "protocol/scene/hash.hpp"

namespace adit::coupler {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kName = "checkpoint.json";

Json to_json(const StateFile& file) {
  return {{"name", file.name}, {"format", file.format}, {"bytes", file.bytes}, {"crc32", file.checksums}};
}

StateFile file_of(const Json& json) {
  return {json.at("name"), json.at("format"), json.at("bytes"),
          json.at("crc32").get<std::vector<std::uint32_t>>()};
}

}  // namespace

std::string hash_of(scene::Scene scene) {
  scene.mutable_time()->clear_duration();
  return protocol::scene_hash(scene);
}

void write_manifest(const std::filesystem::path& folder, const Manifest& m) {
  Json json{{"release", m.release},
            {"scene_hash", m.scene_hash},
            {"at_rest", m.at_rest},
            {"step", m.step},
            {"time_s", m.time},
            {"dt_s", m.dt},
            {"history_stride", m.history_stride},
            {"wall_s", m.wall_s},
            {"case", m.case_name},
            {"notes", m.notes},
            {"command", m.origin.command},
            {"folder", m.origin.folder},
            {"started", m.origin.started},
            {"revision", m.origin.revision},
            {"inputs", m.origin.inputs},
            {"resumed_at_steps", m.resumed}};
  for (const StateFile& file : m.files) json["files"].push_back(to_json(file));
  results::replace_file(folder / kName, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Manifest read_manifest(const std::filesystem::path& folder) try {
  std::ifstream stream(folder / kName, std::ios::binary);
  const Json json = Json::parse(stream);
  Manifest m{.release = json.at("release"),
             .scene_hash = json.at("scene_hash"),
             .at_rest = json.at("at_rest"),
             .step = json.at("step"),
             .time = json.at("time_s"),
             .dt = json.at("dt_s"),
             .history_stride = json.at("history_stride"),
             .wall_s = json.at("wall_s"),
             .case_name = json.at("case"),
             .notes = json.at("notes").get<std::vector<std::string>>(),
             .origin = {.command = json.at("command"),
                        .folder = json.at("folder"),
                        .started = json.at("started"),
                        .revision = json.at("revision"),
                        .inputs = json.at("inputs").get<std::vector<std::pair<std::string, std::string>>>()},
             .resumed = json.at("resumed_at_steps").get<std::vector<std::uint64_t>>()};
  for (const Json& file : json.at("files")) m.files.push_back(file_of(file));
  return m;
} catch (const nlohmann::json::exception&) {
  throw protocol::UserError("", (folder / kName).string() + " cannot be read; take another checkpoint");
}

}  // namespace adit::coupler
