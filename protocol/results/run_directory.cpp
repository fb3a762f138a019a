#include "protocol/results/run_directory.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "protocol/errors.hpp"

namespace adit::results {
namespace {

namespace fs = std::filesystem;

// All files that a run of `coupler` or `simplified` and its pictures leave.
constexpr std::array<std::string_view, 20> kResults = {"summary.json",
                                                       "histories.csv",
                                                       "energies.csv",
                                                       "cracks.csv",
                                                       "capacities.csv",
                                                       "crack_paths.csv",
                                                       "scene.yaml",
                                                       "scene_as_written.yaml",
                                                       "fields",
                                                       "pictures",
                                                       "envelopes.csv",
                                                       "soil_profile.csv",
                                                       "time_distance.csv",
                                                       "joints.csv",
                                                       "zoom",
                                                       "spectra",
                                                       "report.html",
                                                       "motion.csv",
                                                       "reserve",
                                                       "checkpoints"};

// A `.part` file stems from a run that was killed while writing.
bool is_result(fs::path file) {
  if (file.extension() == ".part") file.replace_extension();
  return std::ranges::find(kResults, file.filename().string()) != kResults.end();
}

// Whether a run has written here before: names such as `pictures` and `motion.csv` may be a user's own.
bool is_of_a_run(const fs::path& directory) {
  std::ifstream summary(directory / "summary.json");
  return fs::exists(directory / kLockFile) ||
         nlohmann::json::parse(summary, nullptr, false).contains("scene_hash");
}

}  // namespace

std::string case_name(const fs::path& scene_file) {
  fs::path folder = fs::absolute(scene_file).lexically_normal().parent_path();
  if (folder.filename() == "variants") folder = folder.parent_path();
  return folder.filename().string();
}

FolderLock prepare_run_directory(const fs::path& directory, const fs::path& scene_file) {
  const auto refuse = [&](const std::string& why) {
    throw protocol::UserError(
        "", "the results' directory " + directory.string() + " " + why + "; give another one by --out");
  };
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) refuse("cannot be created: " + error.message());
  if (fs::equivalent(directory, fs::absolute(scene_file).parent_path(), error))
    refuse("holds the scene itself");
  const fs::directory_iterator entries(directory, error);
  if (error) refuse("cannot be read: " + error.message());
  const bool is_ours = is_of_a_run(directory);
  for (const auto& entry : entries) {
    const fs::path name = entry.path().filename();
    if (!is_result(name) && name.extension() != ".log" && name != kLockFile)
      refuse("holds `" + name.string() + "`, which is not a result of a run");
    if (!is_ours)
      refuse("holds `" + name.string() + "`, but neither `summary.json` nor `" + kLockFile +
             "` of a run that could have written it");
  }
  return FolderLock(directory);
}

void clear_results(const fs::path& directory) {
  for (const std::string_view name : kResults) {
    fs::remove_all(directory / name);
    fs::remove(directory / (std::string(name) + ".part"));
  }
}

}  // namespace adit::results
