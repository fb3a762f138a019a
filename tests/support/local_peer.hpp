// A participant in the same process, behind the coupler's view of a server: tests of the method need no
// sockets, and reach the same code.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "coupler/sides/set_up.hpp"
#include "coupler/sides/side.hpp"
#include "dem_server/participant/participant.hpp"
#include "fdm_server/participant/participant.hpp"
#include "protocol/participant/participant.hpp"

namespace adit::test {

class LocalPeer : public coupler::Peer {
 public:
  LocalPeer(std::string name, std::unique_ptr<protocol::Participant> participant)
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

// The sides that the scene needs, in this process.
inline std::vector<coupler::Side> local_sides(const scene::Scene& scene) {
  std::vector<coupler::Side> sides;
  for (const coupler::Member& member : coupler::members(scene)) {
    coupler::Side& side = sides.emplace_back();
    side.member = member;
    if (member.role == coupler::Role::kContinuum)
      side.peer = std::make_unique<LocalPeer>("fdm_server", std::make_unique<fdm::FdmParticipant>());
    else
      side.peer = std::make_unique<LocalPeer>("dem_server", std::make_unique<dem::DemParticipant>());
  }
  return sides;
}

inline coupler::Model local_model(const scene::Scene& scene) {
  return coupler::set_up(scene, local_sides(scene), "test");
}

}  // namespace adit::test
