// Requirements on finding points in zones and on interpolating between grid points.
#include "fdm_server/grid/locate.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "fdm_server/grid/interpolation.hpp"
#include "protocol/errors.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::locate_test {
namespace {

// The bilinear map is inverted to rounding on distorted zones: the shape functions give the point back.
TEST(ZoneLocator, ShapeFunctionsReproduceThePoint) {
  const Grid grid = distorted_grid({-2, 3, 0, 1, 23, 7});
  const ZoneLocator locator(grid);
  for (int i = 0; i < 2000; ++i) {
    const double x = -2 + 5 * std::fmod(0.618034 * i, 1.0), y = std::fmod(0.754878 * i, 1.0);
    const auto place = locator.locate(x, y);
    ASSERT_TRUE(place) << x << " " << y;
    const auto c = corners(grid, place->zone);
    EXPECT_NEAR(std::inner_product(c.x.begin(), c.x.end(), place->shape.begin(), 0.0), x, 1e-13);
    EXPECT_NEAR(std::inner_product(c.y.begin(), c.y.end(), place->shape.begin(), 0.0), y, 1e-13);
    EXPECT_NEAR(std::accumulate(place->shape.begin(), place->shape.end(), 0.0), 1, 1e-15);
  }
}

// A grid point belongs to itself alone, an edge's point to its two ends.
TEST(ZoneLocator, PointsOnCornersAndEdgesTouchNoOtherGridPoint) {
  const Grid grid = make_grid({0, 10, 0, 1, 30, 7});
  const ZoneLocator locator(grid);
  const auto count = [&](double x, double y) {
    const auto place = locator.locate(x, y);
    return place ? std::ranges::count_if(place->shape, [](double n) { return n != 0; }) : -1;
  };
  for (std::size_t i = 0; i < grid.x.size(); ++i) EXPECT_EQ(count(grid.x[i], grid.y[i]), 1);
  EXPECT_EQ(count(5, 0.0), 1);
  EXPECT_EQ(count(5.1, 0.0), 2);
  EXPECT_EQ(count(0, 1e-3), 2);
}

// Outside is outside, also next to the grid and where a hole is.
TEST(ZoneLocator, FindsNothingOutside) {
  Grid grid = make_grid({0, 10, 0, 1, 10, 2});
  std::vector<double> weights = ones(grid);
  weights[4] = 0;
  compact(grid, weights);
  const ZoneLocator locator(grid);
  EXPECT_TRUE(locator.locate(10 + 1e-10, 0.3));
  EXPECT_FALSE(locator.locate(10 + 1e-6, 0.3));
  EXPECT_FALSE(locator.locate(-1e300, 0.3));
  EXPECT_FALSE(locator.locate(4.5, 0.25));
  EXPECT_TRUE(locator.locate(4.5, 0.75));
}

// Rows sum to 1 and reproduce a linear field.
TEST(Interpolation, ReproducesLinearFields) {
  const Grid grid = distorted_grid({0, 4, 0, 2, 8, 4});
  const std::vector<double> places{0.3, 0.4, 2.1, 1.9, 3.99, 0.01, 4, 2};
  const auto rows = interpolate(grid, places);
  ASSERT_EQ(rows.size(), 4u);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    double value = 0, sum = 0;
    for (std::size_t e = 0; e < 4; ++e) {
      const auto [point, share] = std::pair(rows[k].points[e], rows[k].shares[e]);
      value += share * (1 + 2 * grid.x[point] - grid.y[point]);
      sum += share;
    }
    EXPECT_NEAR(value, 1 + 2 * places[2 * k] - places[2 * k + 1], 1e-13);
    EXPECT_NEAR(sum, 1, 1e-15);
  }
}

// A grid point given as a place moves with itself alone, wherever the grid lies.
TEST(Interpolation, AGridPointIsItselfAlone) {
  for (const double offset : {0.0, 1e6}) {
    Grid grid = distorted_grid({0, 10, 0, 1, 30, 7});
    for (auto* values : {&grid.x, &grid.y})
      for (double& value : *values) value += offset;
    for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
      const auto row = interpolate(grid, std::vector<double>{grid.x[i], grid.y[i]}).front();
      for (std::size_t e = 0; e < 4; ++e)
        EXPECT_EQ(row.shares[e], row.points[e] == i ? 1.0 : 0.0) << "point " << i << ", offset " << offset;
    }
  }
}

// A coupling point outside the grid is the user's error, with the point's place and the remedy.
TEST(Interpolation, RefusesPlacesOutside) {
  const Grid grid = make_grid({0, 4, 0, 2, 8, 4});
  try {
    interpolate(grid, std::vector<double>{1, 1, 4.25, 1});
    FAIL() << "no error";
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), "interface.overlap");
    EXPECT_EQ(
        std::string(error.what()),
        "holds the coupling point (4.25, 1) m, which lies outside the continuum; let the continuum cover "
        "the overlap");
  }
}

}  // namespace
}  // namespace adit::fdm::test::locate_test
