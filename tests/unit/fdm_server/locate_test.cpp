// Requirements on finding points in zones and on the interface operator.
#include "fdm_server/locate.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "fdm_server/interface_operator.hpp"
#include "protocol/errors.hpp"
#include "tests/unit/fdm_server/grids.hpp"

namespace adit::fdm::test {
namespace {

// The bilinear map is inverted to rounding on distorted zones: the shape functions give the point back.
TEST(ZoneLocator, ShapeFunctionsReproduceThePoint) {
  const Grid grid = distorted_grid({-2, 3, 0, 1, 23, 7});
  const ZoneLocator locator(grid);
  for (int i = 0; i < 2000; ++i) {
    const double x = -2 + 5 * std::fmod(0.618034 * i, 1.0), y = std::fmod(0.754878 * i, 1.0);
    const auto place = locator.locate(x, y);
    ASSERT_TRUE(place) << x << " " << y;
    const auto c = corners(grid, grid.zones[place->zone]);
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

// Rows sum to 1 and reproduce a linear velocity field; the transpose keeps the total impulse.
TEST(InterfaceOperator, ReproducesLinearFieldsAndKeepsImpulses) {
  const Grid grid = distorted_grid({0, 4, 0, 2, 8, 4});
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  Continuum continuum(make_zones(kKinds[0], grid, plane_stress(kYoung, kPoisson), ones(grid)), masses, {},
                      {});
  const std::vector<double> points{0.3, 0.4, 2.1, 1.9, 3.99, 0.01, 4, 2};
  const InterfaceOperator op(grid, points);
  for (std::size_t i = 0; i < masses.size(); ++i) continuum.vx()[i] = 1 + 2 * grid.x[i] - grid.y[i];
  std::vector<double> velocities(points.size());
  op.velocities(continuum, velocities);
  for (std::size_t k = 0; k < points.size(); k += 2)
    EXPECT_NEAR(velocities[k], 1 + 2 * points[k] - points[k + 1], 1e-13);

  std::ranges::fill(continuum.vx(), 0.0);
  op.apply(std::vector<double>{1, 5, 2, 6, 3, 7, 4, 8}, continuum);
  double px = 0, py = 0;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    px += masses[i] * continuum.vx()[i];
    py += masses[i] * continuum.vy()[i];
  }
  EXPECT_NEAR(px, 10, 1e-13);
  EXPECT_NEAR(py, 26, 1e-13);
}

// A coupling point outside the grid is the user's error, with the point's place.
TEST(InterfaceOperator, RefusesPointsOutside) {
  const Grid grid = make_grid({0, 4, 0, 2, 8, 4});
  try {
    InterfaceOperator(grid, std::vector<double>{1, 1, 4.25, 1});
    FAIL() << "no error";
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), "interface.overlap");
    EXPECT_NE(std::string(error.what()).find("(4.25, 1) m, which lies outside the continuum"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace adit::fdm::test
