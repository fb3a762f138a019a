// Requirements on the warning of large motion: it names the zone that has strained or turned most, once that
// is more than a tenth; to move as a whole is no strain; what was taken away does not count.
#include "fdm_server/participant/large_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace adit::fdm::large_motion_test {
namespace {

// Two zones of 1 m, and the gradient of the displacements in the second one.
struct Moved {
  Grid grid = make_grid({0, 2, 0, 1, 2, 1});
  std::vector<double> weights{1, 1}, ux, uy;

  Moved(double xx, double xy, double yx, double yy) {
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
      const double x = std::max(0.0, grid.x[i] - 1), y = grid.x[i] > 1 ? grid.y[i] : 0;
      ux.push_back(5 + xx * x + xy * y);
      uy.push_back(-3 + yx * x + yy * y);
    }
  }
  std::vector<std::string> warnings() const {
    wire::Bye bye;
    warn_of_large_motion(grid, weights, ux, uy, bye);
    return {bye.warnings().begin(), bye.warnings().end()};
  }
};

TEST(LargeMotion, OfTheWholeIsNone) {
  EXPECT_THAT(Moved(0, 0, 0, 0).warnings(), testing::IsEmpty());
  EXPECT_THAT(Moved(0.09, 0, 0, 0).warnings(), testing::IsEmpty());
}

TEST(LargeMotion, IsStrainOrTurning) {
  EXPECT_THAT(Moved(0.3, 0, 0, 0).warnings(),
              testing::ElementsAre(
                  testing::HasSubstr("at (1.5, 0.5) m has strained by 30 % and turned by 0 degrees")));
  EXPECT_THAT(Moved(0, 0, 0.4, 0).warnings(),
              testing::ElementsAre(testing::HasSubstr("strained by 20 % and turned by 11 degrees")));
}

TEST(LargeMotion, OfWhatWasTakenAwayIsNone) {
  Moved moved(0.3, 0, 0, 0);
  moved.weights[1] = 0;
  EXPECT_THAT(moved.warnings(), testing::IsEmpty());
}

}  // namespace
}  // namespace adit::fdm::large_motion_test
