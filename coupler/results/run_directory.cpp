#include "coupler/results/run_directory.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

namespace fs = std::filesystem;

// All that a run of `coupler` or `simplified`, its servers' logs and its pictures leave.
constexpr std::array<std::string_view, 13> kResults = {
    "summary.json",  "histories.csv",    "cracks.csv",
    "scene.yaml",    "fields",           "pictures",
    "zoom",          "fdm_server.log",   "dem_server.log",
    "envelopes.csv", "soil_profile.csv", "time_distance.csv",
    "joints.csv"};

}  // namespace

std::string case_name(const fs::path& scene_file) {
  fs::path folder = fs::absolute(scene_file).lexically_normal().parent_path();
  if (folder.filename() == "variants") folder = folder.parent_path();
  return folder.filename().string();
}

void prepare_run_directory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error)
    throw protocol::UserError("", "cannot create the results' directory " + directory.string() + ": " +
                                      error.message() + "; give another one by --out");
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (std::find(kResults.begin(), kResults.end(), name) == kResults.end())
      throw protocol::UserError("", "the results' directory " + directory.string() + " holds `" + name +
                                        "`, which is no result of a run; give another one by --out");
  }
  for (const std::string_view name : kResults) fs::remove_all(directory / name);
}

}  // namespace adit::coupler
