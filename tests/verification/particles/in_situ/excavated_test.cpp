// Requirement: a tunnel excavated in stressed ground of particles deforms it and redistributes its stress as
// Kirsch found, in one stage or in several; what is installed later carries what comes later.
#include <gtest/gtest.h>

#include "tests/verification/particles/in_situ/excavated.hpp"

namespace adit::excavated_test {
namespace {

constexpr double kDisc = 0.125;

std::string lattice(const std::string& more) {
  return test::tunnel_in_lattice(kDisc, more);
}

using test::excavation;

// Up to an error of first order in the discs' size: the outer halves of the discs at the wall carry nothing,
// which makes the hole larger than what was taken away. excavated_finely_test.cpp shows a finer lattice.
TEST(ExcavatedParticles, DeformAsKirschFound) {
  test::Settled settled(lattice(excavation("", 1) + test::kHoop));
  test::expect_kirsch(settled, kDisc, 0.95 * kDisc / test::kHole, 0.03);
}

TEST(ExcavatedParticles, EndAtTheSameStateInTwoStages) {
  test::Settled once(lattice(excavation("", 1))),
      twice(lattice(excavation("y_min: 0", 1) + excavation("", 3))),
      released(lattice(excavation("", 1, 0.5)));
  const test::Drawn a(once.stepper.snapshots()[1]), b(twice.stepper.snapshots()[1]),
      c(released.stepper.snapshots()[1]);
  ASSERT_EQ(a.x.size(), b.x.size());
  ASSERT_EQ(a.x.size(), c.x.size());
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    EXPECT_LT(std::hypot(a.ux[i] - b.ux[i], a.uy[i] - b.uy[i]), 0.01 * a.largest());
    EXPECT_LT(std::hypot(a.ux[i] - c.ux[i], a.uy[i] - c.uy[i]), 0.01 * a.largest());
    if (HasFailure()) return;
  }
}

// Mean stress, xx, yy and xy, in a plug of stiff particles that comes back in the second stage.
std::vector<double> stress_of_plug(double released) {
  return test::Settled(
             lattice(excavation("", 1, released) +
                     "groups { name: 'lining' where { circle { centre { x: 0 y: 0 } radius: 1.5 } } stage: 2 "
                     "bonds { normal_stiffness: 1e10 shear_stiffness: 3e9 } } " +
                     test::stress_over(0.6, 0, 0.6)))
      .histories[1];
}

TEST(ExcavatedParticles, LiningAfterReleaseCarriesNothing) {
  for (const double stress : stress_of_plug(1)) EXPECT_LT(std::abs(stress), 1e-3 * -test::kFar.yy);
}

// Bonds that do not break are linear: the plug bears its part of what is released after it.
TEST(ExcavatedParticles, LiningCarriesWhatIsReleasedAfterIt) {
  const auto all = stress_of_plug(0), part = stress_of_plug(0.7);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(all[i], 0.4 * test::kFar.yy);
    EXPECT_NEAR(part[i], 0.3 * all[i], 1e-2 * -test::kFar.yy);
  }
}

}  // namespace
}  // namespace adit::excavated_test
