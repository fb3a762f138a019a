// Scenes of discs, small.
#pragma once

#include <string>

#include "protocol/messages/scene.pb.h"

namespace adit::dem::test {

inline constexpr double kDensity = 2500;

inline scene::Scene empty_scene() {
  scene::Scene scene;
  scene.set_plane(scene::PLANE_STRESS);
  scene.mutable_time()->set_duration(1);
  auto& material = *scene.mutable_material();
  material.set_young_modulus(10e9);
  material.set_poisson_ratio(0.2);
  material.set_density(kDensity);
  scene.mutable_particles();
  return scene;
}

template <class Packing>
void set_box(Packing& packing, double width, double height) {
  packing.set_x_min(0);
  packing.set_x_max(width);
  packing.set_y_min(0);
  packing.set_y_max(height);
}

// Columns and rows of discs of radius 0.5 m, the lower left one at (0.5, 0.5).
inline scene::Scene square_scene(int columns, int rows) {
  auto scene = empty_scene();
  auto& packing = *scene.mutable_particles()->mutable_square_packing();
  set_box(packing, columns, rows);
  packing.set_radius(0.5);
  return scene;
}

inline scene::Scene random_scene() {
  auto scene = empty_scene();
  auto& packing = *scene.mutable_particles()->mutable_random_packing();
  set_box(packing, 2, 1);
  packing.set_radius_min(0.03);
  packing.set_radius_max(0.05);
  packing.set_stress(1e7);
  return scene;
}

inline scene::Scene placed_scene(const std::string& content) {
  auto scene = empty_scene();
  auto& placed = *scene.mutable_particles()->mutable_placed();
  placed.set_path("particles");
  placed.set_content(content);
  return scene;
}

inline void set(scene::Point& point, double x, double y) {
  point.set_x(x);
  point.set_y(y);
}

}  // namespace adit::dem::test
