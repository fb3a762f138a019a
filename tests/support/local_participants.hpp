// A participant in the same process, which the coupler sees as a server. Tests of the method then need no
// sockets and run the same code.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "coupler/participants/participant.hpp"
#include "coupler/participants/set_up.hpp"
#include "dem_server/participant/participant.hpp"
#include "fdm_server/participant/participant.hpp"
#include "protocol/participant/participant.hpp"

namespace adit::test {

class LocalConnection : public coupler::Connection {
 public:
  LocalConnection(std::string name, std::unique_ptr<protocol::Participant> participant)
      : name_(std::move(name)), participant_(std::move(participant)), conversation_(*participant_) {}

  const std::string& name() const override { return name_; }
  void post(const wire::Frame& request) override {
    conversation_.answer(request, reply_);
    conversation_.complete();
  }
  void collect(wire::Frame& reply) override { reply.Swap(&reply_); }

 private:
  std::string name_;
  std::unique_ptr<protocol::Participant> participant_;
  protocol::Conversation conversation_;
  wire::Frame reply_;
};

// The participants that the scene needs, in this process.
inline std::vector<coupler::Participant> local_participants(const scene::Scene& scene) {
  std::vector<coupler::Participant> participants;
  for (const coupler::Member& member : coupler::members(scene)) {
    coupler::Participant& participant = participants.emplace_back();
    participant.member = member;
    if (member.role == coupler::Role::kContinuum)
      participant.connection =
          std::make_unique<LocalConnection>("fdm_server", std::make_unique<fdm::FdmParticipant>());
    else
      participant.connection =
          std::make_unique<LocalConnection>("dem_server", std::make_unique<dem::DemParticipant>());
  }
  return participants;
}

inline coupler::Model local_model(const scene::Scene& scene) {
  return coupler::set_up(scene, local_participants(scene), "test");
}

}  // namespace adit::test
