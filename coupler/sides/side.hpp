// One participant as the coupler sees it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupler/bridging/interpolation.hpp"
#include "coupler/sides/members.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::coupler {

// The way to a participant: a server at the other end of a connection, or an object in the same process.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual const std::string& name() const = 0;
  virtual void post(const wire::Frame& request) = 0;  // does not wait for the answer
  virtual void collect(wire::Frame& reply) = 0;       // the answer to the request posted last
};

// Coupling points of one interface among those of a side: `count` of them from the side's own `begin`, from
// `global` in the model's list.
struct Segment {
  std::size_t begin, global, count;
  bool coarse;  // the side interpolates there; else each of them is a point of its own
};

struct Side {
  Member member;
  std::unique_ptr<Peer> peer;
  wire::Model model;
  wire::Interface counts;
  std::size_t histories = 0;                   // that the scene asks of it
  std::string interface_path = "interface";    // in the scene, of its last interface
  std::vector<Segment> segments;               // its coupling points
  std::optional<Interpolation> interpolation;  // where it has any

  // Reused in every step; one pair for each of its coupling points.
  wire::Frame request, reply;
  std::vector<double> impulses;     // on this side in this step [N s]
  std::vector<double> predicted;    // velocities [m/s]
  std::vector<double> corrected;    // the same after the correction
  std::vector<double> own;          // scratch: one pair for each own point
  bool impulses_pending = false;    // computed, but not yet sent
  std::vector<wire::Crack> cracks;  // reported and not yet recorded
  wire::BondForce strongest;        // the largest bond force since it was recorded
  double compute_s = 0;  // what the participant computed so far while it was waited for, by its clock
  double hidden_s = 0;   // and while it was not

  const wire::Predicted& prediction() const { return reply.predicted(); }
};

// Collects the answer to what was posted and checks its kind; anything else is protocol::PeerLost. What the
// participant says against its part of the scene is a protocol::UserError at that place of the whole scene.
void collect(Side& side, wire::Frame::ContentCase expected);

}  // namespace adit::coupler
