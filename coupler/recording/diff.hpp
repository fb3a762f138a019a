// Compares two recordings.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "protocol/messages/wire.pb.h"

namespace adit::coupler {

// Where two frames differ.
struct Difference {
  std::string field;  // "predicted.velocities[3]"
  std::string a, b;   // the values there
};

// The first field that differs, numbers by their bits. Fields that may differ in runs of one scene are left
// out, and cleared: kNotCompared.
std::optional<Difference> first_difference(wire::Frame& a, wire::Frame& b);

// Exit code of a comparison that found a difference, as of diff and cmp.
inline constexpr int kDifferent = 1;

inline constexpr const char* kNotCompared =
    "names of run and scene, the scene's description, clocks, memory, contents of states, programs and "
    "releases";

// Prints, for each participant, the first request and the first answer that differ, the earliest before the
// others. Requests of states are left out: when they come depends on the clock, and they change nothing.
// Returns the exit code: 0, or kDifferent. Throws protocol::UserError for a file that cannot be read.
int diff(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace adit::coupler
