// Overlaps at free faces, with the real zones and particles: both models end together there.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "coupler/participants/set_up.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/refusals.hpp"

namespace adit::coupler::free_face_test {
namespace {

scene::Scene scene_of(const std::string& text) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } time { duration: 0.01 }" + text,
      &scene))
      << text;
  return scene;
}

// Ground below the slope from (0, 10) to (20, 0) m, zones of half a metre; particles of it below a parallel
// line.
scene::Scene portal(double depth) {
  const auto corner = [](double x, double y) {
    return " corners { x: " + std::to_string(x) + " y: " + std::to_string(y) + " }";
  };
  return scene_of(
      "continuum { blocks { quadrilateral {" + corner(0, -10) + corner(20, -10) + corner(20, 0) +
      corner(0, 10) +
      "} along { zones: 40 } across { zones: 30 } } }"
      "particles { packing { x_min: 5 x_max: 15 y_min: -5 y_max: 8 radius: 0.1 } within { polygon {" +
      corner(5, -5) + corner(15, -5) + corner(15, 2.5 - depth) + corner(5, 7.5 - depth) +
      "} } }"
      "interface { solve: SPLIT overlap { width: 1.5 around { box { x_min: 7.5 x_max: 12.5 y_min: -2.5 "
      "y_max: 10 } "
      "} } }");
}

// Requirement: a ring may cross a sloping face; the particles right below it are coupled.
TEST(FreeFace, ASlopingPortalIsJoined) {
  const Model model = test::local_model(portal(0.15));
  double highest = -100;  // above the plane y = -x / 2
  for (std::size_t i = 0; i < model.coupling_points.size(); i += 2)
    highest = std::max(highest, model.coupling_points[i + 1] + model.coupling_points[i] / 2);
  EXPECT_LE(highest, 10 - 0.15 + 1e-9);
  EXPECT_GE(highest, 10 - 0.15 - 0.1);
}

TEST(FreeFace, ParticlesThatEndBelowTheSlopeAreRefused) {
  test::expect_refusal([] { test::local_model(portal(1)); }, "interface.overlap",
                       "is not filled by `particles` at (");
}

// A cavern 8 m wide and high, particles over its crown.
scene::Scene crown(const std::string& cavern) {
  return scene_of("continuum { block { x_min: -10 x_max: 10 y_min: -10 y_max: 12 zones_x: 40 zones_y: 44 }" +
                  cavern +
                  "}"
                  "particles { packing { x_min: -4.6 x_max: 4.6 y_min: 4 y_max: 9.5425627 radius: 0.1 } }"
                  "interface { solve: SPLIT overlap { width: 1 around { box { x_min: -3 x_max: 3 y_min: 4 "
                  "y_max: 8 } } } }");
}

// Requirement: zones that are excavated from the start are no ground that the particles would have to fill.
TEST(FreeFace, TheCrownOfACavernIsJoined) {
  const Model model =
      test::local_model(crown("excavations { where { x_min: -4 x_max: 4 y_min: -4 y_max: 4 } }"));
  ASSERT_FALSE(model.coupling_points.empty());
  for (std::size_t i = 1; i < model.coupling_points.size(); i += 2) EXPECT_GE(model.coupling_points[i], 4);
}

TEST(FreeFace, WithoutTheCavernThereIsGroundToFill) {
  test::expect_refusal([] { test::local_model(crown("")); }, "interface.overlap",
                       "is not filled by `particles` at (");
}

}  // namespace
}  // namespace adit::coupler::free_face_test
