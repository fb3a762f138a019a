// What a checkpoint says of itself: the file checkpoint.json of its folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"
#include "protocol/scene/origin.hpp"

namespace adit::coupler {

// The state of a participant, or of the coupler itself: the file NAME.state.
struct StateFile {
  std::string name;    // "particles", "coupler"
  std::string format;  // who can read it: wire.proto, Model.state_format
  std::uint64_t bytes = 0;
  std::vector<std::uint32_t> checksums = {};  // CRC-32 of each part (protocol/state/archive.hpp)
};

struct Manifest {
  std::string release;               // of the coupler that wrote it
  std::string scene_hash;            // hash_of(scene)
  bool at_rest = false;              // statics are done and time has not begun
  std::uint64_t step = 0;            // of time, the last one that was made; 0 in statics
  double time = 0;                   // [s]
  double dt = 0;                     // [s]
  std::uint64_t history_stride = 1;  // steps between two rows of histories.csv
  double wall_s = 0;                 // that the run took until then
  // How the run began (RunLabels), and the steps from which it has gone on since.
  std::string case_name;
  std::vector<std::string> notes = {};
  protocol::Origin origin = {};
  std::vector<std::uint64_t> resumed = {};
  std::vector<StateFile> files = {};
};

// Of the scene but for its duration, which may become another when the run goes on.
std::string hash_of(scene::Scene scene);

void write_manifest(const std::filesystem::path& folder, const Manifest& manifest);
// Throws protocol::UserError where there is none that can be read, where anything in it is not what was
// written, and where it is of another release.
Manifest read_manifest(const std::filesystem::path& folder);

}  // namespace adit::coupler
