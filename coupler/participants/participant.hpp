// One participant as the coupler sees it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupler/bridging/interpolation.hpp"
#include "coupler/participants/connection.hpp"
#include "coupler/participants/correction.hpp"
#include "coupler/participants/members.hpp"
#include "protocol/messages/wire.pb.h"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

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
  std::vector<double> places;                      // of these, x0 y0 x1 y1 … [m]
  std::optional<Interpolation> interpolation;      // where it has any

  // Its own step over the model's. Velocities times it are those of the model's clock, and impulses at the
  // coupling points over it: with masses m / ratio² in one clock, the motion is the same. Statics use it
  // (time_step.hpp).
  double step_ratio = 1;
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
};

// Collects the answer to what was posted; another kind, or one that is not sound (answers.hpp), is
// protocol::PeerLost. What the
// participant says against its part of the scene is a protocol::UserError at that place of the whole scene.
void collect(Participant& participant, wire::Frame::ContentCase expected);

// Ends all participants; afterwards the last reply of each is its Bye.
void finish(std::vector<Participant>& participants);

}  // namespace adit::coupler
