// The cantilever of the paper as a scene of particles only.
#pragma once

#include <cmath>
#include <numbers>

#include "dem_server/model/calibration.hpp"
#include "tests/unit/dem_server/in_process_run.hpp"

namespace adit::dem::test {

inline constexpr double kCantileverRadius = 10.0 / 156;

inline scene::Scene cantilever_scene() {
  scene::Scene scene;
  scene.set_plane(scene::PLANE_STRESS);
  scene.mutable_time()->set_duration(0.05);
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

}  // namespace adit::dem::test
