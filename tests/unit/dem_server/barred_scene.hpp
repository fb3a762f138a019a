// A member of cells with one bar along it.
#pragma once

#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::test {

// Of concrete, 1 m by 0.2 m, of cells of 40 mm; bars of 16 mm every 0.15 m from end to end in its middle.
inline scene::Scene barred_member() {
  auto scene = empty_scene();
  auto& cells = *scene.mutable_particles()->mutable_cells();
  set_box(cells, 1, 0.2);
  cells.set_size(0.04);
  auto& material = *scene.mutable_material();
  material.set_young_modulus(33e9);
  auto& fracture = *material.mutable_fracture();
  fracture.set_tensile_strength(2.9e6);
  fracture.set_fracture_energy(140);
  fracture.set_compressive_strength(38e6);
  auto& bar = *scene.mutable_particles()->add_bars();
  auto& line = *bar.mutable_along()->mutable_line();
  set(*line.add_points(), 0, 0.1);
  set(*line.add_points(), 1, 0.1);
  bar.set_diameter(0.016);
  bar.set_spacing(0.15);
  bar.mutable_steel()->set_class_("B500B");
  return scene;
}

}  // namespace adit::dem::test
