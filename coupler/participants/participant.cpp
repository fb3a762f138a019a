#include "coupler/participants/participant.hpp"

#include <algorithm>

#include "coupler/answers/answers.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

// A participant knows its model as `continuum` or `particles`, and its interfaces as `interface`.
std::string path_in_scene(const std::string& path, const Participant& participant) {
  const auto replaced = [&](const std::string& from, const std::string& to) {
    return to + path.substr(from.size());
  };
  const std::string own = to_string(participant.member.role), interface = "interface";
  if (path.rfind(own, 0) == 0) return replaced(own, participant.member.path);
  if (path.rfind(interface, 0) == 0) return replaced(interface, participant.interface_path);
  return path;
}

}  // namespace

void Participant::exchange(state::Archive& archive) {
  correction.exchange(archive);
  archive("predicted", std::span(predicted));
  archive("corrected", std::span(corrected));
  wire::Predicted events;
  for (const wire::Crack& crack : cracks) *events.add_cracks() = crack;
  *events.add_strongest() = strongest;
  std::string reported = events.SerializeAsString();
  archive("reported", reported);
  if (archive.reads() && events.ParseFromString(reported) && events.strongest_size() == 1) {
    cracks.assign(events.cracks().begin(), events.cracks().end());
    strongest = events.strongest(0);
  }
  archive("compute_s", compute_s);
  archive("hidden_s", hidden_s);
}

void collect(Participant& participant, wire::Frame::ContentCase expected) {
  try {
    participant.connection->collect(participant.reply);
  } catch (const protocol::UserError& error) {
    throw protocol::UserError(path_in_scene(error.path(), participant), error.what());
  }
  if (participant.reply.content_case() == expected)
    return require_sound(participant.reply, participant.connection->name());
  const auto* descriptor = wire::Frame::descriptor();
  const auto name = [&](int number) {
    const auto* field = descriptor->FindFieldByNumber(number);
    return field != nullptr ? field->name() : std::string("nothing");
  };
  throw protocol::PeerLost(
      participant.connection->name(),
      "answered " + name(participant.reply.content_case()) + " where " + name(expected) + " was expected");
}

void finish(std::vector<Participant>& participants) {
  for (Participant& participant : participants) {
    participant.request.mutable_finish();
    participant.connection->post(participant.request);
  }
  for (Participant& participant : participants) collect(participant, wire::Frame::kBye);
}

}  // namespace adit::coupler
