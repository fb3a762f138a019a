// Tunnels for tests, from text as it is written in a scene.
#pragma once

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"

namespace adit::test {

inline scene::LinedTunnel tunnel_of(const std::string& text) {
  scene::LinedTunnel tunnel;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &tunnel)) << text;
  return tunnel;
}

// A circle of 3 m inside a lining of half a metre, in 2 m of ground.
inline std::string circular(const std::string& lining = "", const std::string& more = "") {
  return "centre { x: 1 y: -12 } circle { radius: 3 } lining { thickness: 0.5 material { young_modulus: 35e9 "
         "poisson_ratio: 0.2 density: 2500 } " +
         lining + " } particles { radius: 0.05 ground: 2 overlap: 1 } " + more;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

inline scene::Scene scene_with(const std::vector<std::string>& tunnels) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(
    name: 'ring'
    material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 }
    time { duration: 0.01 }
    continuum {
      block { x_min: -19 x_max: 21 y_min: -32 y_max: 0 zones_x: 80 zones_y: 64 }
      body_loads { acceleration { y: -9.81 } }
      body_loads { where { y_min: -1 } acceleration { y: -1 } }
    }
  )",
                                                            &scene));
  for (const std::string& tunnel : tunnels) *scene.add_tunnels() = tunnel_of(tunnel);
  return scene;
}

}  // namespace adit::test
