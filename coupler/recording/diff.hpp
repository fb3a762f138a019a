// Compares two recordings.
#pragma once

#include <filesystem>

namespace adit::coupler {

// Prints, for each participant, the first request and the first answer that differ, the earliest before the
// others. Requests of states are left out: when they come depends on the clock, and they change nothing.
// Returns the exit code: 0, or kDifferent. Throws protocol::UserError for a file that cannot be read.
int diff(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace adit::coupler
