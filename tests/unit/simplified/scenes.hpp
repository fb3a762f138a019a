// A short tunnel, of which each test changes one part.
#pragma once

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <string>

#include "protocol/messages/scene.pb.h"
#include "simplified/run.hpp"

namespace adit::simplified::testing {

inline scene::Scene scene_of(const std::string& text) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene));
  return scene;
}

// 200 m, two sections, a joint every 25 m, springs given, shaken by a wavelet that passes along it.
inline scene::Scene tunnel() {
  return scene_of(R"(
    time { duration: 2 dt: 0.005 }
    simplified {
      model: BEAM
      tunnel {
        sections { from: 0 to: 100 width: 7 height: 7 area: 9.5 lateral_inertia: 48 vertical_inertia: 48
                   young_modulus: 35e9 mass: 5e4 element_length: 1 }
        sections { from: 100 to: 200 width: 7 height: 7 area: 9.5 lateral_inertia: 48 vertical_inertia: 48
                   young_modulus: 35e9 mass: 5e4 element_length: 1 }
        joints { name: "ring" from: 25 to: 175 spacing: 25 axial_stiffness: 5e9 rotation_stiffness: 3e10
                 lateral_keys { stiffness: 2e10 } vertical_keys { stiffness: 2e10 } seal_limit: 0.01 }
      }
      soil_springs { axial: 5e7 lateral: 5e7 vertical: 5e7 dashpot_time: 0.01 }
      excitation { motion { ricker { frequency: 2 time: 0.8 } peak: 3 }
                   incidence { apparent_velocity: 300 } lateral: 1 }
      stations { name: "middle" chainage: 100 }
      zoom { width: 40 }
    }
  )");
}

// The same shaking on an immersed tube: wider than high, with unequal inertias, and joints that turn as
// stiffly as their place on the perimeter makes them.
inline scene::Scene immersed_tunnel() {
  scene::Scene scene = tunnel();
  auto& tunnel = *scene.mutable_simplified()->mutable_tunnel();
  for (auto& section : *tunnel.mutable_sections()) {
    section.set_width(38);
    section.set_height(11);
    section.set_area(158);
    section.set_lateral_inertia(2.4e4);
    section.set_vertical_inertia(2.5e3);
    section.set_mass(4e5);
  }
  tunnel.mutable_joints(0)->set_axial_stiffness(1e12);
  tunnel.mutable_joints(0)->clear_rotation_stiffness();
  auto& springs = *scene.mutable_simplified()->mutable_soil_springs();
  springs.set_axial(4e8);
  springs.set_lateral(4e8);
  springs.set_vertical(4e8);
  return scene;
}

inline scene::Scene with_model(scene::Scene scene, scene::Simplified::Model model) {
  scene.mutable_simplified()->set_model(model);
  return scene;
}

inline Response response_of(const scene::Scene& scene) {
  const auto setup = set_up(scene);
  return solve(setup, shake(setup));
}

}  // namespace adit::simplified::testing
