// Where the results of a run go.
#pragma once

#include <filesystem>
#include <string>

namespace adit::results {

// The case that a scene file belongs to: its folder's name; `variants` folders belong to the case above.
std::string case_name(const std::filesystem::path& scene_file);

// Creates the directory where it is absent. One that holds anything but the results of a run, or the scene
// itself, is a protocol::UserError. Nothing in it is touched.
void prepare_run_directory(const std::filesystem::path& directory, const std::filesystem::path& scene_file);

// Takes the results of an older run out of a prepared directory; logs of servers stay.
void clear_results(const std::filesystem::path& directory);

}  // namespace adit::results
