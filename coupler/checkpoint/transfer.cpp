#include "coupler/checkpoint/transfer.hpp"

#include <algorithm>

#include "coupler/checkpoint/state_file.hpp"
#include "protocol/errors.hpp"
#include "protocol/wire/bounds.hpp"

namespace adit::coupler {
namespace {

void ask(Participant& participant, std::uint64_t offset) {
  participant.request.mutable_save()->set_offset(offset);
  participant.connection->post(participant.request);
}

// The part that was asked for; throws protocol::PeerLost for one that is not what it should be.
const wire::State& receive(Participant& participant, std::uint64_t offset) {
  collect(participant, wire::Frame::kState);
  const wire::State& state = participant.reply.state();
  const auto samples = static_cast<std::uint64_t>(participant.model.sample_points_size()) / 2;
  const auto lost = [&](const char* why) {
    throw protocol::PeerLost(participant.connection->name(), std::string("sent a part of its state ") + why);
  };
  if (state.size() > protocol::most_state_bytes(samples)) lost("that is larger than one of its model can be");
  if (offset >= state.size() ||
      state.data().size() != std::min<std::uint64_t>(state.size() - offset, state::kPartBytes))
    lost("of a wrong size");
  if (state::checksum(state.data()) != state.checksum()) lost("with a wrong checksum");
  return state;
}

}  // namespace

bool all_save_states(const std::vector<Participant>& participants) {
  return std::ranges::none_of(
      participants, [](const Participant& participant) { return participant.model.state_format().empty(); });
}

std::vector<StateFile> save(std::vector<Participant>& participants, const std::filesystem::path& folder) {
  for (Participant& participant : participants) ask(participant, 0);
  std::vector<StateFile> files;
  for (Participant& participant : participants) {
    StateWriter writer(folder, participant.member.name, participant.model.state_format());
    std::uint64_t offset = 0, size = 0;
    do {
      const wire::State& state = receive(participant, offset);
      size = state.size();
      offset += state.data().size();
      if (offset < size) ask(participant, offset);  // it prepares the next part while this one is written
      writer.append(state.data(), state.checksum());
    } while (offset < size);
    files.push_back(writer.close());
  }
  return files;
}

void restore(Participant& participant, const std::filesystem::path& folder, const StateFile& file) {
  wire::Restore& request = *participant.request.mutable_restore();
  request.set_size(file.bytes);
  StateReader reader(folder, file);
  std::uint64_t offset = 0;
  for (bool more = reader.next(*request.mutable_data()); more;) {
    request.set_offset(offset);
    request.set_checksum(reader.checksum());
    participant.connection->post(participant.request);
    offset += request.data().size();
    more = reader.next(*request.mutable_data());  // while the participant takes the part
    collect(participant, wire::Frame::kRestored);
  }
}

}  // namespace adit::coupler
