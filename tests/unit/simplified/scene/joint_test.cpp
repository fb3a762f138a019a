// A joint turns as its parts on the perimeter of the cross-section make it, in both planes and both models.
#include "simplified/scene/joint.hpp"

#include <gtest/gtest.h>

namespace adit::simplified::joint_test {
namespace {

constexpr double kStiffness = 5e9;

// Wider than high, higher than wide.
constexpr Outline kOutlines[] = {{38, 11.4}, {4, 9}};

// Mean square of the distance from the axis over the perimeter of a rectangle, in small pieces; `along`: its
// size in the plane of the rotation.
double mean_square(double along, double across) {
  constexpr int kPieces = 2000;
  double sum = 0;
  for (int i = 0; i < kPieces; ++i) {
    const double place = along * ((i + 0.5) / kPieces - 0.5);
    sum += 2 * along / kPieces * place * place;
  }
  return (sum + 2 * across * along * along / 4) / (2 * (along + across));
}

scene::Joints linear_joint() {
  scene::Joints group;
  group.set_axial_stiffness(kStiffness);
  return group;
}

TEST(Joint, OfTheBeamTurnsAsItsPerimeterInBothPlanes) {
  for (const Outline& outline : kOutlines) {
    double axial = 0, lateral = 0, vertical = 0;
    for (const auto& spring : beam_joint(linear_joint(), outline, 0).springs) {
      const double stiffness = spring.curve.tangent(0);
      axial += stiffness;
      lateral += stiffness * spring.y * spring.y;
      vertical += stiffness * spring.z * spring.z;
    }
    EXPECT_NEAR(axial, kStiffness, 1e-9 * kStiffness);
    EXPECT_NEAR(lateral / (kStiffness * mean_square(outline.width, outline.height)), 1, 1e-6);
    EXPECT_NEAR(vertical / (kStiffness * mean_square(outline.height, outline.width)), 1, 1e-6);
  }
}

// In series with the lining beside it, in the horizontal plane.
TEST(Joint, OfTheChainTurnsAsItsPerimeter) {
  const Flexibility lining{1e-11, 1e-10, 1e-12};
  for (const Outline& outline : kOutlines) {
    const chain::Hinge hinge = simplified::hinge(linear_joint(), outline, lining);
    const double rotation = kStiffness * mean_square(outline.width, outline.height);
    EXPECT_NEAR(hinge.rotation.stiffness * (1 / rotation + lining.rotation), 1, 1e-6);
    EXPECT_NEAR(hinge.axial.stiffness * (1 / kStiffness + lining.axial), 1, 1e-12);
  }
}

}  // namespace
}  // namespace adit::simplified::joint_test
