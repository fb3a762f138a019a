// Requirement: errors do not grow in long runs. Nothing moves in 10^7 steps at rest; in 10^6 steps of free
// vibration the consistent solve keeps energy to a thousandth, and the other solves only lose it.
//
// These tests take minutes and have the label `nightly` in ctest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/verification/bridging/bars.hpp"

namespace adit::endurance_test {
namespace {

constexpr auto kGrid = test::Stretch::kGrid, kLattice = test::Stretch::kLattice;
// As small as a bar of both can be: it is the number of steps that counts.
const test::Bar kBar{"", {{kGrid, 0, 5, 1}, {kLattice, 2.6, 8, 0.3}}, {{0, 1, 3, 5}}};

struct Endurance : testing::TestWithParam<scene::Solve> {};

TEST_P(Endurance, RestStaysRestForTenMillionSteps) {
  coupler::Model model = test::local_model(test::scene_of(kBar, GetParam()));
  coupler::Stepper stepper(model);
  constexpr std::uint64_t kSteps = 10'000'000;
  for (std::uint64_t n = 0; n <= kSteps; ++n) stepper.step(n, {.energies = n % 1'000'000 == 0});
  EXPECT_EQ(stepper.ledger().stored(), 0);
  for (const coupler::Participant& participant : model.participants)
    for (const double velocity : participant.predicted) EXPECT_EQ(velocity, 0);
}

// Energies are looked at at every hundredth step; the work of the multipliers is summed at every one.
TEST_P(Endurance, AMillionStepsOfFreeVibration) {
  scene::Scene scene = test::scene_of(kBar, GetParam());
  test::push_left_end({3e3, 1e3, 0.005}, kBar, scene);
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  constexpr std::uint64_t kSteps = 1'000'000, kLook = 100;
  const auto free = static_cast<std::uint64_t>(std::ceil(0.005 / model.dt / kLook)) * kLook;
  double before = 0, rise = 0, peak = 0, at_start = 0, drift = 0;
  for (std::uint64_t n = 0; n <= kSteps; ++n) {
    const bool looks = n % kLook == 0;
    stepper.step(n, {.energies = looks});
    if (!looks) continue;
    const double unexplained = stepper.ledger().unexplained();
    peak = std::max(peak, stepper.ledger().stored());
    if (n <= free) before = at_start = unexplained;
    rise = std::max(rise, unexplained - before);
    drift = std::max(drift, std::abs(unexplained - at_start));
    before = unexplained;
  }
  RecordProperty("drift", std::to_string(drift / peak));
  RecordProperty("kept", std::to_string(stepper.ledger().kept()));
  if (GetParam() == scene::CONSISTENT) {
    EXPECT_LE(drift, 1e-3 * peak);
  } else {
    EXPECT_LE(rise, 1e-12 * peak);
  }
}

INSTANTIATE_TEST_SUITE_P(AllSolves, Endurance,
                         testing::Values(scene::CONSISTENT, scene::LUMPED, scene::SPLIT),
                         [](const auto& info) { return scene::Solve_Name(info.param); });

}  // namespace
}  // namespace adit::endurance_test
