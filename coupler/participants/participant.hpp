// One participant as the coupler sees it.
#pragma once

#include <google/protobuf/repeated_field.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupler/bridging/interpolation.hpp"
#include "coupler/participants/members.hpp"
#include "protocol/messages/spans.hpp"
#include "protocol/messages/wire.pb.h"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

// The way to a participant: a server at the other end of a connection, or an object in the same process.
class Connection {
 public:
  virtual ~Connection() = default;
  virtual const std::string& name() const = 0;
  virtual void post(const wire::Frame& request) = 0;  // does not wait for the answer
  virtual void collect(wire::Frame& reply) = 0;       // the answer to the request posted last
  // How far the participant is meanwhile, where it says so; from any thread.
  virtual std::string progress() const { return {}; }
};

// The multipliers' impulses on one participant, at its coupling points: computed for a step, sent once.
class Correction {
 public:
  Correction() = default;
  explicit Correction(std::size_t coupling_points) : impulses_(2 * coupling_points, 0.0) {}

  // One pair for each coupling point [N s].
  std::span<const double> impulses() const { return impulses_; }
  // For those of the next step, to be written by the caller, which are then to be sent.
  std::span<double> renew() {
    pending_ = true;
    return impulses_;
  }
  // Those of the coupling points from this one on.
  std::span<double> impulses_from(std::size_t point) { return std::span(impulses_).subspan(2 * point); }
  // They are not to be sent.
  void withhold() { pending_ = false; }
  // Fills the field, unless they were sent or withheld.
  void send(google::protobuf::RepeatedField<double>& field) {
    if (pending_) std::ranges::copy(impulses_, protocol::resize(field, impulses_.size()).begin());
    pending_ = false;
  }

  void exchange(state::Archive& archive) {
    archive("impulses", std::span(impulses_));
    archive("pending", pending_);
  }

 private:
  std::vector<double> impulses_;
  bool pending_ = false;
};

// Coupling points of one interface among those of a participant: `count` of them from the participant's own
// `begin`, from `global` in the model's list.
struct Segment {
  std::size_t begin, global, count;
  bool coarse;  // the participant interpolates there; else each of them is a point of its own
};

struct Participant {
  Member member;
  std::unique_ptr<Connection> connection;
  wire::Model model;
  wire::Interface counts;                  // of what exists under the weights; its points are
  std::vector<double> candidates;          // those that may become coupling points, x0 y0 x1 y1 … [m]
  std::vector<scene::Quantity> histories;  // that the scene asks of it
  std::optional<std::vector<std::string>> shares;  // names of the parts of its energies, once it told them
  std::string interface_path = "interface";        // in the scene, of its last interface
  std::vector<Segment> segments;                   // its coupling points
  // Where the coupling points begin that are points of its own and no interface ties: grid points around
  // regions that wait (stepping/condensed_regions.hpp). Impulses on them last a step.
  std::size_t nodes_begin = 0;
  std::vector<double> places;                  // of all coupling points, x0 y0 x1 y1 … [m]
  std::optional<Interpolation> interpolation;  // where it has any

  // Its own step over the model's. Velocities times it are those of the model's clock, and impulses at the
  // coupling points over it: with masses m / ratio² in one clock, the motion is the same. Statics use it
  // (time_step.hpp).
  double step_ratio = 1;
  bool waits = false;                    // condensed (stepping/condensed_regions.hpp): no step asks for it
  bool scaled_masses = false;            // it has those of statics (wire.proto, Advance)
  std::optional<protocol::Drift> drift;  // to be sent with the next step

  // Reused in every step; one pair for each of its coupling points.
  wire::Frame request, reply;
  Correction correction;            // of this step
  std::vector<double> predicted;    // velocities [m/s]
  std::vector<double> corrected;    // the same after the correction
  std::vector<double> own;          // scratch: one pair for each own point
  std::vector<wire::Crack> cracks;  // reported and not yet recorded
  wire::BondForce strongest;        // the largest bond force since it was recorded
  double compute_s = 0;  // what the participant computed so far while it was waited for, by its clock
  double hidden_s = 0;   // and while it was not

  // What the coupler knows of it from step to step.
  void exchange(state::Archive& archive);

  const wire::Predicted& prediction() const { return reply.predicted(); }
  // Its coupling points of the interface whose first one has this place in the model's list.
  const Segment& segment_from(std::size_t global) const {
    return *std::ranges::find(segments, global, &Segment::global);
  }
};

// Collects the answer to what was posted; another kind, or one that is not sound (answers.hpp), is
// protocol::PeerLost. What the participant says against its part of the scene is a protocol::UserError at
// that place of the whole scene.
void collect(Participant& participant, wire::Frame::ContentCase expected);

// Ends all participants; afterwards the last reply of each is its Bye.
void finish(std::vector<Participant>& participants);

}  // namespace adit::coupler
