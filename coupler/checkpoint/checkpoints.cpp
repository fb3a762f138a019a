#include "coupler/checkpoint/checkpoints.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "coupler/checkpoint/state_file.hpp"
#include "coupler/checkpoint/transfer.hpp"
#include "protocol/errors.hpp"
#include "protocol/results/disk/growing_file.hpp"
#include "protocol/standard_streams.hpp"

namespace adit::coupler {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKept = 3;
constexpr const char* kAtRest = "at_rest";
constexpr const char* kAside = "unfinished";

bool is_at_rest(const fs::path& folder) {
  return folder.filename().string().ends_with(kAtRest);
}

// By their numbers, oldest first.
std::vector<fs::path> finished(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (entry.path().filename() != kAside && fs::exists(entry.path() / "checkpoint.json"))
      found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

int next_number(const fs::path& folder) {
  const auto before = finished(folder);
  return before.empty() ? 1 : std::atoi(before.back().filename().c_str()) + 1;
}

Checkpoint read_one(const fs::path& folder) {
  Checkpoint checkpoint{folder, read_manifest(folder)};
  for (const StateFile& file : checkpoint.manifest.files) require_whole(folder, file);
  return checkpoint;
}

}  // namespace

Checkpoint read_checkpoint(const fs::path& folder, bool at_rest) {
  if (fs::exists(folder / "checkpoint.json")) {
    Checkpoint checkpoint = read_one(folder);
    if (at_rest && !checkpoint.manifest.at_rest)
      throw protocol::UserError("", folder.string() +
                                        " is no state after statics, from which alone another run can begin; "
                                        "coupler resume goes on with its own run");
    return checkpoint;
  }
  std::vector<fs::path> found = finished(folder / "checkpoints");
  if (at_rest) std::erase_if(found, [](const fs::path& one) { return !is_at_rest(one); });
  if (found.empty())
    throw protocol::UserError(
        "", folder.string() + (at_rest ? " has no checkpoint after statics" : " has no checkpoint") +
                "; `output.checkpoint` writes them, and so does a run that a signal ends");
  for (; found.size() > 1; found.pop_back()) try {
      return read_one(found.back());
    } catch (const protocol::UserError& error) {
      protocol::print_error(fmt::format("warning: {}\n", error.what()));
    }
  return read_one(found.front());
}

Checkpoints::Checkpoints(const fs::path& results, std::optional<std::chrono::duration<double>> interval)
    : folder_(results / "checkpoints"), interval_(interval) {}

bool Checkpoints::any() const {
  return !finished(folder_).empty();
}

void Checkpoints::write(const std::string& name, Manifest manifest, std::vector<Participant>& participants,
                        const std::map<std::string, state::Parts>& of_coupler) {
  const Clock::time_point start = Clock::now();
  const fs::path aside = folder_ / kAside;
  fs::remove_all(aside);
  // Not create_directories(): where the results have been removed, the run must end, not begin another
  // folder.
  fs::create_directory(folder_);
  fs::create_directory(aside);
  try {
    manifest.files = save(participants, aside);
    for (const auto& [state, parts] : of_coupler) {
      StateWriter writer(aside, state, manifest.release);
      for (const std::string& part : parts) writer.append(part, state::checksum(part));
      manifest.files.push_back(writer.close());
    }
    write_manifest(aside, manifest);
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(aside, ignored);
    throw;
  }
  fs::rename(aside, folder_ / fmt::format("{:06}_{}", next_number(folder_), name));
  auto rolling = finished(folder_);
  std::erase_if(rolling, is_at_rest);
  for (std::size_t k = 0; k + kKept < rolling.size(); ++k) fs::remove_all(rolling[k]);
  last_ = Clock::now();
  seconds_ = std::chrono::duration<double>(last_ - start).count();
}

}  // namespace adit::coupler
