#include "protocol/results/run_directory.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "protocol/errors.hpp"

namespace adit::results {
namespace {

namespace fs = std::filesystem;

// All files that a run of `coupler` or `simplified` and its pictures leave. A `.part` file stems from a run
// that was killed while writing.
constexpr std::array<std::string_view, 17> kResults = {"summary.json",
                                                       "summary.json.part",
                                                       "histories.csv",
                                                       "energies.csv",
                                                       "cracks.csv",
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
                                                       "motion.csv"};

bool is_result(const fs::path& file) {
  return std::find(kResults.begin(), kResults.end(), file.filename().string()) != kResults.end();
}

}  // namespace

std::string case_name(const fs::path& scene_file) {
  fs::path folder = fs::absolute(scene_file).lexically_normal().parent_path();
  if (folder.filename() == "variants") folder = folder.parent_path();
  return folder.filename().string();
}

void prepare_run_directory(const fs::path& directory, const fs::path& scene_file) {
  const auto refuse = [&](const std::string& why) {
    throw protocol::UserError(
        "", "the results' directory " + directory.string() + " " + why + "; give another one by --out");
  };
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) refuse("cannot be created: " + error.message());
  if (fs::equivalent(directory, fs::absolute(scene_file).parent_path(), error))
    refuse("holds the scene itself");
  for (const auto& entry : fs::directory_iterator(directory))
    if (!is_result(entry.path()) && entry.path().extension() != ".log")
      refuse("holds `" + entry.path().filename().string() + "`, which is not a result of a run");
}

void clear_results(const fs::path& directory) {
  for (const std::string_view name : kResults) fs::remove_all(directory / name);
}

}  // namespace adit::results
