// From a scene to participants that are ready to step: set-up, weights, coupling points, operators, time
// step.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "coupler/bridging/overlap_notes.hpp"
#include "coupler/participants/constraint.hpp"
#include "coupler/participants/interface.hpp"
#include "coupler/participants/participant.hpp"
#include "coupler/participants/stated.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

struct Model {
  scene::Scene scene;
  std::vector<Participant> participants;  // in the order of members()
  std::vector<Interface> interfaces;
  std::vector<double> coupling_points;     // of all interfaces in turn, x0 y0 x1 y1 … [m]
  std::unique_ptr<Constraint> constraint;  // of coupled runs
  double critical_dt = 0;                  // of the particles' steps: the smallest of the participants [s]
  std::uint64_t steps = 0;
  double dt = 0;          // steps · dt is the duration, or less than dt more [s]
  unsigned substeps = 1;  // of the particles in one step
  // For the user: notes of the participants and on the time step; what of the model is likely to be wrong.
  std::vector<std::string> notes = {}, warnings = {};
  std::vector<Stated> stated = {};  // that does not act as it is stated
};

bool has_particles(const Model& model);

// One of the models of an interface; it refers to the participant.
Side side_of(const scene::Scene& scene, const Participant& participant);

// Takes every participant, one for each of members(scene) in their order, through setup, weights and couple.
// Throws protocol::UserError with the scene's path for what cannot be computed: no overlap, an overlap
// outside a model or without particles, overlaps that meet, a time step above the critical one.
// `dt`: the step of a run that goes on [s], 0 of one that begins.
Model set_up(const scene::Scene& scene, std::vector<Participant> participants, const std::string& run_id,
             double dt = 0);

}  // namespace adit::coupler
