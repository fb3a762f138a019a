// Requirement: Lamb's problem, the surface motion under a vertical line load, within 2 % of its closed form
// at all times (of the largest motion at the receiver), for receivers several Rayleigh wavelengths away.
#include <gtest/gtest.h>

#include "tests/verification/continuum/lamb_run.hpp"

namespace adit::fdm::test::lamb_test {
namespace {

void expect_two_percent(const std::vector<Peaks>& receivers) {
  for (const auto& receiver : receivers) {
    EXPECT_LE(receiver.error_x, 0.02 * receiver.exact_x);
    EXPECT_LE(receiver.error_y, 0.02 * receiver.exact_y);
  }
}

TEST(Lamb, AssumedStrainIsWithinTwoPercentAtThreeWavelengths) {
  expect_two_percent(lamb_errors(ZoneKind::kAssumedStrain, {1, 2, 3}, 64));
}

TEST(Lamb, MixedDiscretizationIsWithinTwoPercentAtFourWavelengths) {
  expect_two_percent(lamb_errors(ZoneKind::kMixedDiscretization, {1, 2, 4}, 32));
}

}  // namespace
}  // namespace adit::fdm::test::lamb_test
