// Where the results of a run go.
#pragma once

#include <filesystem>
#include <string>

namespace adit::coupler {

// The case that a scene file belongs to: its folder's name; `variants` folders belong to the case above.
std::string case_name(const std::filesystem::path& scene_file);

// Creates the directory, or takes the results of an older run out of it. A directory that holds anything but
// a run's results is a protocol::UserError: nothing of it is touched.
void prepare_run_directory(const std::filesystem::path& directory);

}  // namespace adit::coupler
