// One participant as the coupler sees it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupler/bridging/interpolation.hpp"
#include "protocol/wire.pb.h"

namespace adit::coupler {

// The way to a participant: a server at the other end of a connection, or an object in the same process.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual const std::string& name() const = 0;
  virtual void post(const wire::Frame& request) = 0;  // does not wait for the answer
  virtual void collect(wire::Frame& reply) = 0;       // the answer to the request posted last
};

enum class Role { kContinuum, kParticles };
const char* to_string(Role role);  // "continuum", "particles": the scene's own names

struct Side {
  Role role;
  std::unique_ptr<Peer> peer;
  wire::Model model;
  wire::Interface counts;
  std::size_t histories = 0;                   // that the scene asks of it
  std::optional<Interpolation> interpolation;  // of coupled runs

  // Reused in every step.
  wire::Frame request, reply;
  std::vector<double> impulses;   // on this side in this step [N s]
  std::vector<double> predicted;  // velocities at the coupling points [m/s]
  std::vector<double> corrected;  // the same after the correction
  std::vector<double> own;        // scratch: one pair for each own point
  double compute_s = 0;           // what the participant computed so far, by its own clock

  const wire::Predicted& prediction() const { return reply.predicted(); }
};

// Collects the answer to what was posted and checks its kind; anything else is protocol::PeerLost.
void collect(Side& side, wire::Frame::ContentCase expected);

}  // namespace adit::coupler
