#include "coupler/checkpoint/manifest.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "protocol/errors.hpp"
#include "protocol/release.hpp"
#include "protocol/results/atomic_file.hpp"
#include "protocol/scene/hash.hpp"
#include "protocol/text.hpp"

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

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

// The manifest, whose last member is the hash of all others: one flipped bit would be another run.
Json read_whole(const std::filesystem::path& file) {
  const auto refuse = [&file](const std::string& why) {
    throw protocol::UserError("", file.string() + " " + why + "; take another checkpoint");
  };
  if (!std::filesystem::is_regular_file(file)) refuse("is not a file");
  std::ifstream stream(file, std::ios::binary);
  Json json = Json::parse(stream);
  // Another release may write another manifest.
  const std::string release = json.at("release");
  if (release != protocol::release())
    throw protocol::UserError(
        "", file.parent_path().string() + " is of release " + protocol::shorten(release) + ", this is " +
                std::string(protocol::release()) + "; go on with that release, or begin again");
  const std::string hash = json.at("hash");
  json.erase("hash");
  if (protocol::hash_of_bytes(text_of(json)) != hash) refuse("is damaged: its hash is another one");
  return json;
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
  json["hash"] = protocol::hash_of_bytes(text_of(json));
  results::replace_file(folder / kName, text_of(json) + "\n");
}

Manifest read_manifest(const std::filesystem::path& folder) try {
  const Json json = read_whole(folder / kName);
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
