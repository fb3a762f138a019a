// The folder of a run's results.
#pragma once

#include <filesystem>
#include <string>

#include "protocol/results/folder_lock.hpp"

namespace adit::results {

// The case to which a scene file belongs: the name of its folder, or of the folder above a folder `variants`.
std::string case_name(const std::filesystem::path& scene_file);

// Creates the directory if it is absent, holds it for this process, and touches no result in it. Throws
// protocol::UserError if another process holds it, and if it holds the scene itself, anything that is not a
// result of a run, or files of such names that no run has written: nothing of a user's own is ever removed.
[[nodiscard]] FolderLock prepare_run_directory(const std::filesystem::path& directory,
                                               const std::filesystem::path& scene_file);

// Removes the results of an older run from a prepared directory; logs of servers stay.
void clear_results(const std::filesystem::path& directory);

}  // namespace adit::results
