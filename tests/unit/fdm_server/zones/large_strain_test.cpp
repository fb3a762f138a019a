// Requirement: in large strain the stress that is reported is the true one, of the present area: times the
// present width it is the force that the work on the plate says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/fdm_server/boundaries/boundary_scenes.hpp"

namespace adit::fdm::test::large_strain_test {
namespace {

constexpr double kWidth = 6, kHeight = 2, kSqueeze = 0.2;
constexpr int kRows = 4, kSteps = 4000;

// A block between two plates, the upper one coming down by a fifth of the height; every point moves as the
// block shortens evenly and, `sideways`, as it widens or narrows by this share.
std::string squeezed(const std::string& zone, double rate, double sideways) {
  std::string scene = fmt::format(
      "block {{ x_min: 0 x_max: {} y_min: 0 y_max: {} zones_x: 3 zones_y: {} }} large_strain: true {}",
      kWidth, kHeight, kRows, zone);
  for (int row = 0; row <= kRows; ++row) {
    const double y = kHeight * row / kRows;
    scene += fmt::format("motions {{ where {{ y_min: {} y_max: {} }} velocity {{ y: {} }} }} ", y - 0.1,
                         y + 0.1, -rate * y);
  }
  for (int column = 0; column <= 3; ++column) {
    const double x = kWidth * column / 3;
    scene += fmt::format("motions {{ where {{ x_min: {} x_max: {} }} velocity {{ x: {} }} }} ", x - 0.1,
                         x + 0.1, rate * sideways / kSqueeze * x);
  }
  return scene +
         "histories { name: 'a' quantity: STRESS_XX at { x: 3 y: 1 } } "
         "histories { name: 'a' quantity: STRESS_YY at { x: 3 y: 1 } } ";
}

// The power of both pairs of sides in the last step, over the step, from the stresses before and after it.
TEST(LargeStrain, StressTimesPresentWidthIsTheForceOnThePlate) {
  for (const std::string zone : {"", "zone: MIXED_DISCRETIZATION "})
    for (const double sideways : {0.0, 0.1}) {
      GroundRun run(squeezed(zone, 1, sideways), 1);
      run.dt = kSqueeze / kSteps;
      double work = 0, expected = 0, before = 0;
      for (int n = 0; n <= kSteps; ++n) {
        const auto& answer = run.advance();
        const double t = n * run.dt, stretch = sideways / kSqueeze;
        const double width = kWidth * (1 + stretch * t), height = kHeight * (1 - t);
        const double power =
            answer.histories(0) * height * stretch * kWidth - answer.histories(1) * width * kHeight;
        if (n == kSteps) {
          work = answer.energies().external_work() - work;
          expected = run.dt * (before + power) / 2;
        } else {
          work = answer.energies().external_work();
          before = power;
        }
      }
      EXPECT_GT(expected, 0);
      EXPECT_NEAR(work / expected, 1, 1e-4) << zone << sideways;
    }
}

}  // namespace
}  // namespace adit::fdm::test::large_strain_test
