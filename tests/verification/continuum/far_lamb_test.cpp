// Requirement: Lamb's problem within 2 % as far as six wavelengths from the load (minutes; see
// lamb_test.cpp).
#include <gtest/gtest.h>

#include "tests/verification/continuum/lamb_run.hpp"

namespace adit::fdm::test::far_lamb_test {
namespace {

TEST(Lamb, IsWithinTwoPercentAtSixWavelengths) {
  for (const auto& receiver : lamb_errors(ZoneKind::kAssumedStrain, {2, 4, 6}, 96)) {
    EXPECT_LE(receiver.error_x, 0.02 * receiver.exact_x);
    EXPECT_LE(receiver.error_y, 0.02 * receiver.exact_y);
  }
}

}  // namespace
}  // namespace adit::fdm::test::far_lamb_test
