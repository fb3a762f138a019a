// Interfaces without a unique solution are refused by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/local_participants.hpp"
#include "tests/support/overlaps.hpp"
#include "tests/support/refusals.hpp"
#include "tests/verification/bridging/bars.hpp"

namespace adit::coupler::ill_posed_test {
namespace {

constexpr auto kGrid = test::Stretch::kGrid, kLattice = test::Stretch::kLattice;

void expect_refusal(const scene::Scene& scene, const std::string& path, const std::string& text) {
  adit::test::expect_refusal([&] { test::local_model(scene); }, path, text);
}

void expect_refusal(const test::Bar& bar, const std::string& path, const std::string& text) {
  expect_refusal(test::scene_of(bar), path, text);
}

// The same under the key `interface`, which participants and solves name.
scene::Scene with_one_interface(const test::Bar& bar, scene::Solve solve = scene::CONSISTENT) {
  scene::Scene scene = test::scene_of(bar, solve);
  *scene.mutable_interface() = scene.interfaces(0);
  scene.clear_interfaces();
  return scene;
}

TEST(IllPosed, AnOverlapBetweenTwoColumnsOfParticles) {
  expect_refusal({"", {{kGrid, 0, 5, 0.5}, {kLattice, 3, 8, 0.1}}, {{0, 1, 3.52, 3.55}}},
                 "interfaces[0].overlap", "holds no particle");
}

TEST(IllPosed, AnOverlapBetweenTwoGridLines) {
  expect_refusal({"", {{kGrid, 0, 5, 0.5}, {kGrid, 3, 8, 0.25}}, {{0, 1, 3.55, 3.65}}},
                 "interfaces[0].overlap", "holds no grid point");
}

// Half of the grid's motions would be tied to no particle.
TEST(IllPosed, AGridFinerThanTheParticles) {
  for (const scene::Solve solve : {scene::CONSISTENT, scene::LUMPED, scene::SPLIT}) {
    const test::Bar bar{"", {{kGrid, 0, 5, 0.1}, {kLattice, 3, 8, 0.1}}, {{0, 1, 3, 5}}};
    expect_refusal(with_one_interface(bar, solve), "interface.overlap", "finer than the points");
  }
}

// A notch between the samples of the weight: its zones vanish, its particles do not.
TEST(IllPosed, ParticlesOutsideTheGrid) {
  scene::Scene scene =
      with_one_interface({"", {{kGrid, 0, 8, 0.5}, {kLattice, 0, 8, 0.05}}, {{0, 1, 3, 4, 5}}});
  auto& overlap = *scene.mutable_interface()->mutable_overlap();
  overlap = test::interface_of(
                "overlap { around { polygon { corners { x: 3 y: -1 } corners { x: 5 y: -1 } "
                "corners { x: 5 y: 2 } corners { x: 4.15 y: 2 } corners { x: 4.15 y: 0.3 } "
                "corners { x: 4.1 y: 0.3 } corners { x: 4.1 y: 2 } corners { x: 3 y: 2 } } } "
                "width: 1 }")
                .overlap();
  expect_refusal(scene, "interface.overlap", "outside the continuum");
}

TEST(IllPosed, TwoInterfacesThatFightForAPoint) {
  expect_refusal({"",
                  {{kGrid, 0, 8, 0.5}, {kLattice, 0, 5, 0.05}, {kLattice, 3, 8, 0.05}},
                  {{0, 1, 4.5, 2.5}, {0, 2, 4, 6}}},
                 "interfaces[1].overlap", "move the overlaps apart");
}

// The middle model's points are tied to the grid's, and the lattice's to them. Rows of particles are 0.05 m
// times the root of 3 apart, the lowest at half of that.
TEST(IllPosed, APointThatIsCoarseAndFine) {
  expect_refusal({"",
                  {{kGrid, 0, 5, 0.5}, {kGrid, 2, 6, 0.25}, {kLattice, 3, 8, 0.05}},
                  {{0, 1, 2.5, 4}, {1, 2, 4, 5.5}}},
                 "interfaces[1].overlap",
                 "ties the point (4.05, 0.0433013) m of `stretch_2`, which interfaces[0] ties already");
}

// Each of the two overlaps holds the particles at x = 4 m on which they meet: those of the second row are the
// first ones.
TEST(IllPosed, TwoOverlapsThatMeetOnAColumnOfParticles) {
  expect_refusal({"",
                  {{kGrid, 0, 4.5, 0.5}, {kLattice, 2, 6, 0.05}, {kGrid, 3.5, 8, 0.5}},
                  {{0, 1, 3, 4}, {2, 1, 5, 4}}},
                 "interfaces[1].overlap",
                 "ties the point (4, 0.129904) m of `stretch_1`, which another interface ties already");
}

TEST(IllPosed, AMotionPrescribedInTheOverlap) {
  scene::Scene scene = with_one_interface({"", {{kGrid, 0, 5, 0.5}, {kLattice, 3, 8, 0.1}}, {{0, 1, 3, 5}}});
  auto& motion = *scene.mutable_regions(1)->mutable_particles()->add_motions();
  motion.mutable_where()->set_x_max(3.5);
  motion.mutable_velocity()->set_x(0);
  expect_refusal(scene, "interface.overlap", "motion is prescribed");
}

TEST(IllPosed, SolvesThatDiffer) {
  scene::Scene scene = test::scene_of({"",
                                       {{kGrid, 0, 8, 0.25}, {kLattice, 0, 4, 0.05}, {kLattice, 4, 8, 0.05}},
                                       {{0, 1, 3, 2}, {0, 2, 5, 6}}});
  scene.mutable_interfaces(1)->set_solve(scene::LUMPED);
  expect_refusal(scene, "interfaces[1].solve", "solved together");
}

}  // namespace
}  // namespace adit::coupler::ill_posed_test
