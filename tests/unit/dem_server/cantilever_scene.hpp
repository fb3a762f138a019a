// The cantilever of the paper as a scene of particles only, and a participant that runs it in process.
#pragma once

#include <cmath>
#include <numbers>

#include "dem_server/participant/participant.hpp"

namespace adit::dem::test {

inline constexpr double kCantileverRadius = 10.0 / 156;

inline scene::Scene cantilever_scene() {
  scene::Scene scene;
  scene.set_plane(scene::PLANE_STRESS);
  auto& material = *scene.mutable_material();
  material.set_young_modulus(25e9);
  material.set_poisson_ratio(0.2);
  material.set_density(2500);
  auto& packing = *scene.mutable_particles()->mutable_packing();
  packing.set_x_min(0);
  packing.set_x_max(10);
  packing.set_y_min(0);
  packing.set_y_max(9 * std::numbers::sqrt3 * kCantileverRadius);
  packing.set_radius(kCantileverRadius);
  auto& load = *scene.mutable_particles()->add_loads();
  load.mutable_where()->set_x_max(kCantileverRadius);
  load.mutable_force()->set_y(5e6);
  auto& sine = *load.mutable_time()->mutable_sine();
  sine.set_frequency(50);
  sine.set_end(0.01);
  auto& fixed = *scene.mutable_particles()->add_motions();
  fixed.mutable_where()->set_x_min(10 - kCantileverRadius);
  fixed.mutable_velocity()->set_x(0);
  fixed.mutable_velocity()->set_y(0);
  fixed.set_spin(0);
  auto& tip = *scene.mutable_particles()->add_histories();
  tip.set_name("tip");
  tip.set_quantity(scene::DISPLACEMENT_Y);
  tip.mutable_at()->set_x(0);
  tip.mutable_at()->set_y(packing.y_max() / 2);
  return scene;
}

// A participant after set_up and weigh, with the messages that it answered.
struct InProcessRun {
  DemParticipant participant;
  wire::Model model;
  wire::Interface interface;
  wire::Predicted predicted;
  std::uint64_t next = 0;
  double dt;

  explicit InProcessRun(const scene::Scene& scene, const wire::Weights& weights = {},
                        double dt_factor = 0.5) {
    wire::Setup setup;
    *setup.mutable_scene() = scene;
    participant.set_up(setup, model);
    participant.weigh(weights, interface);
    dt = dt_factor * model.critical_dt();
  }

  const wire::Predicted& advance(const std::vector<double>& impulses = {}) {
    wire::Advance request;
    request.set_step(next++);
    request.set_dt(dt);
    request.mutable_impulses()->Assign(impulses.begin(), impulses.end());
    request.set_want_energies(true);
    request.set_want_histories(true);
    predicted.Clear();
    participant.advance(request, predicted);
    return predicted;
  }
};

}  // namespace adit::dem::test
