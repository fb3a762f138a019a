#include "coupler/run_state.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "coupler/checkpoint/state_file.hpp"
#include "coupler/checkpoint/transfer.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

constexpr const char *kCoupler = "coupler", *kOutputs = "outputs";

void exchange_coupling(RunState& run, state::Archive& archive) {
  for (Participant& participant : run.model.participants) participant.exchange(archive);
  run.stepper.exchange(archive);
  if (run.statics) run.statics->exchange(archive);
  archive("next_step", run.next_step);
}

void exchange_outputs(RunState& run, state::Archive& archive) {
  run.recorder.exchange(archive);
  run.motions.exchange(archive);
  run.watch.exchange(archive);
  archive("stepping_s", run.stepping_s);
}

const StateFile& file_of(const Checkpoint& checkpoint, const std::string& name) {
  const auto& files = checkpoint.manifest.files;
  const auto found = std::ranges::find(files, name, &StateFile::name);
  if (found == files.end())
    throw protocol::UserError(
        "", fmt::format("{} has no state of `{}`; it is of another scene", checkpoint.folder.string(), name));
  return *found;
}

void require_readable(const Checkpoint& checkpoint, const Participant& participant) {
  const std::string& wanted = file_of(checkpoint, participant.member.name).format;
  const std::string& able = participant.model.state_format();
  if (wanted == able) return;
  throw protocol::UserError(
      "",
      fmt::format("the state of `{}` in {} is of {}, but {} {}; go on with the program that saved it",
                  participant.member.name, checkpoint.folder.string(), wanted, participant.connection->name(),
                  able.empty() ? "reads no states" : "reads those of " + able));
}

template <class Exchange>
void read(const Checkpoint& checkpoint, const char* name, Exchange&& exchange) {
  state::Archive archive(read_state(checkpoint.folder, file_of(checkpoint, name)));
  exchange(archive);
  archive.require_end();
}

}  // namespace

std::map<std::string, state::Parts> RunState::save() {
  state::Archive coupling, outputs;
  exchange_coupling(*this, coupling);
  exchange_outputs(*this, outputs);
  return {{kCoupler, coupling.take()}, {kOutputs, outputs.take()}};
}

void RunState::restore(const Checkpoint& checkpoint, bool same_run) {
  for (const Participant& participant : model.participants) require_readable(checkpoint, participant);
  for (Participant& participant : model.participants)
    coupler::restore(participant, checkpoint.folder, file_of(checkpoint, participant.member.name));
  read(checkpoint, kCoupler, [this](state::Archive& archive) { exchange_coupling(*this, archive); });
  if (const std::uint64_t step = next_step > 0 ? next_step - 1 : 0; step != checkpoint.manifest.step)
    throw protocol::UserError(
        "", fmt::format("{} is of step {}, but its state of the coupler of step {}; take another checkpoint",
                        checkpoint.folder.string(), checkpoint.manifest.step, step));
  if (!same_run) return;
  read(checkpoint, kOutputs, [this](state::Archive& archive) { exchange_outputs(*this, archive); });
  resumed = checkpoint.manifest.resumed;
  resumed.push_back(checkpoint.manifest.step);
}

}  // namespace adit::coupler
