// The plain product of transfer matrices: right while it has digits, and honest when it has none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/errors.hpp"
#include "tests/unit/simplified/chain/chains.hpp"

namespace adit::simplified::chain {
namespace {

// s = m A of the segment for dt = 5 ms, k = 2 GN/m.
const double kDigitsAJoint = std::acosh(1 + 9.5e6 * 4 / (0.005 * 0.005) / (2 * 2e9)) / std::log(10);

DigitsLost after_one_step(const Chain& chain) {
  Simulation run(chain, {.dt = 0.005, .sweep = Sweep::kTransferMatrix});
  std::vector<double> load(chain.bodies.size());
  for (std::size_t i = 0; i < load.size(); ++i) load[i] = 1e6 * std::cos(static_cast<double>(i));
  run.step({.load_x = load});
  return run.digits_lost();
}

// The prediction is that of theory: 2.9 digits a joint for a 22.5 m immersed segment at 5 ms.
TEST(TransferMatrix, PredictsItsLoss) {
  EXPECT_NEAR(kDigitsAJoint, 2.9, 0.05);
  for (const std::size_t n : {2, 5, 30}) {
    const Simulation run(test::segments(n), {.dt = 0.005});
    EXPECT_NEAR(run.digits_lost().predicted, kDigitsAJoint * (static_cast<double>(n) - 1), 1e-6 * n);
  }
}

// It loses what is predicted, within a digit, up to 5 joints, and is dead after 6: predicted, measured and
// said.
TEST(TransferMatrix, DiesAfterSixJoints) {
  for (const std::size_t joints : {2, 3, 4, 5}) {
    const DigitsLost lost = after_one_step(test::segments(joints + 1));
    EXPECT_NEAR(lost.measured, kDigitsAJoint * static_cast<double>(joints), 1) << joints << " joints";
    EXPECT_FALSE(lost.dead()) << joints << " joints";
  }
  const DigitsLost lost = after_one_step(test::segments(7));
  EXPECT_GT(lost.predicted, 15.65);
  EXPECT_NEAR(lost.measured, 15.65, 0.5);
  EXPECT_TRUE(lost.dead());
}

// While it has digits the product gives the Riccati sweep's motion, step after step, with soil, turns and
// abutment.
TEST(TransferMatrix, AgreesWhileItHasDigits) {
  Chain chain = test::winding(4);
  for (Hinge& hinge : chain.hinges)
    for (HingeDirection* d : {&hinge.axial, &hinge.shear, &hinge.rotation}) d->stiffness *= 100;
  Simulation product(chain, {.dt = 0.02, .sweep = Sweep::kTransferMatrix}), riccati(chain, {.dt = 0.02});
  ASSERT_LT(product.digits_lost().predicted, 5);
  test::Wave wave(4);
  for (int step = 1; step <= 500; ++step) {
    const Excitation excitation = wave.at(0.02 * step);
    product.step(excitation);
    riccati.step(excitation);
    for (std::size_t i = 0; i < 4; ++i) ASSERT_NEAR(product.bodies().x[i], riccati.bodies().x[i], 1e-9);
  }
}

// A chain far too long for it ends with an error that says why and what to do.
TEST(TransferMatrix, SaysWhyItFails) {
  Simulation run(test::segments(200), {.dt = 0.005, .sweep = Sweep::kTransferMatrix});
  EXPECT_TRUE(run.digits_lost().dead());
  const std::vector<double> load(200, 1e6);
  try {
    for (int step = 0; step < 1000; ++step) run.step({.load_x = load});
    FAIL() << "went on";
  } catch (const protocol::Unstable& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("take the Riccati sweep"));
  }
}

}  // namespace
}  // namespace adit::simplified::chain
