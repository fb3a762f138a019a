// From a scene to participants that are ready to step: set-up, weights, coupling points, operators, time
// step.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupler/bridging/multipliers.hpp"
#include "coupler/bridging/overlap.hpp"
#include "coupler/side.hpp"
#include "protocol/scene.pb.h"

namespace adit::coupler {

struct Model {
  scene::Scene scene;
  std::vector<Side> sides;              // the continuum first, where there are both
  std::optional<Overlap> overlap;       // of coupled runs, like the solve
  std::vector<double> coupling_points;  // x0 y0 x1 y1 … [m]
  std::unique_ptr<MultiplierSolve> solve;
  double critical_dt = 0;  // smallest of the participants [s]
  std::uint64_t steps = 0;
  double dt = 0;  // steps · dt = duration [s]
};

// The roles that the scene needs. Throws protocol::UserError for a scene that is neither one model nor two
// models with an interface.
std::vector<Role> roles(const scene::Scene& scene);

// What the scene wants to know of a participant, in the order of its answers.
const google::protobuf::RepeatedPtrField<scene::History>& histories_of(const scene::Scene& scene, Role role);

// Takes every side through setup, weights and couple. Throws protocol::UserError with the scene's path for
// what cannot be computed: no overlap, an overlap outside a model or without particles, a time step above
// the critical one.
Model set_up(const scene::Scene& scene, std::vector<Side> sides, const std::string& run_id);

}  // namespace adit::coupler
