// Requirements on slivers: zones of which an overlap leaves next to nothing vanish, and a motion that is
// linear in the place passes through where they were.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fdm_server/grid/interpolation.hpp"
#include "fdm_server/grid/samples.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm::slivers_test {
namespace {

// Weights 0 up to `begin`, then a ramp over `width`.
std::vector<double> ramp(const Grid& grid, double begin, double width) {
  const auto points = sample_points(grid);
  std::vector<double> samples;
  for (std::size_t i = 0; i < points.size(); i += 2)
    samples.push_back(std::min(1.0, std::max(0.0, (points[i] - begin) / width)));
  return samples;
}

// Of the zone from x = 1 to 2 a tenth lies in the overlap of width 2, and weighs less than 0.01.
TEST(Slivers, VanishAndTheNextZoneGoesOn) {
  Grid grid = make_grid({0, 6, 0, 2, 6, 2});
  const auto samples = ramp(grid, 1.9, 2);
  auto weights = zone_weights(grid, samples, 1e-6);
  const auto before = weights;
  const auto slivers = drop_slivers(grid, samples, weights);
  ASSERT_EQ(slivers.size(), 2u);
  EXPECT_GT(before[1], 0);
  for (std::size_t z = 0; z < weights.size(); ++z) EXPECT_EQ(weights[z], z % 6 == 1 ? 0 : before[z]);

  compact(grid, weights);
  const double x = 1.93, y = 0.3;
  EXPECT_THROW(interpolate(grid, std::vector{x, y}), protocol::UserError);
  const auto row = interpolate(grid, std::vector{x, y}, slivers)[0];
  double sum = 0, value = 0;
  for (int k = 0; k < 4; ++k) {
    const auto point = static_cast<std::size_t>(row.points[k]);
    sum += row.shares[k];
    value += row.shares[k] * (3 + 2 * grid.x[point] - 5 * grid.y[point]);
  }
  EXPECT_NEAR(sum, 1, 1e-14);
  EXPECT_NEAR(value, 3 + 2 * x - 5 * y, 1e-13);
  EXPECT_THROW(interpolate(grid, std::vector{0.5, 0.3}, slivers), protocol::UserError)
      << "where there was no sliver there is no grid";
}

// A zone that lies in the overlap as a whole stays, however little the ramp gives it.
TEST(Slivers, AreNotLightZonesOfAWideOverlap) {
  const Grid grid = make_grid({0, 6, 0, 2, 6, 2});
  auto samples = ramp(grid, 1, 200);
  auto weights = zone_weights(grid, samples, 1e-6);
  EXPECT_LT(weights[1], 0.01);
  EXPECT_TRUE(drop_slivers(grid, samples, weights).empty());
}

// Nor is one of which the overlap leaves much.
TEST(Slivers, AreNotZonesOfWeight) {
  const Grid grid = make_grid({0, 6, 0, 2, 6, 2});
  auto samples = ramp(grid, 1.6, 0.5);
  auto weights = zone_weights(grid, samples, 1e-6);
  EXPECT_TRUE(drop_slivers(grid, samples, weights).empty());
}

}  // namespace
}  // namespace adit::fdm::slivers_test
