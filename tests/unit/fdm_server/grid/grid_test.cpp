// Requirements on the grid, its weights and what vanishes.
#include "fdm_server/grid/grid.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "fdm_server/grid/samples.hpp"
#include "fdm_server/zones/kernel/zone_runs.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::grid_test {
namespace {

const Block kBlock{-1, 3, 0.5, 2, 4, 3};

template <class Function>
std::vector<double> sampled(const Grid& grid, Function&& weight) {
  const auto points = sample_points(grid);
  std::vector<double> result;
  for (std::size_t i = 0; i < points.size(); i += 2) result.push_back(weight(points[i], points[i + 1]));
  return result;
}

// Zones are counter-clockwise and cover the block.
TEST(Grid, ZonesCoverTheBlock) {
  const Grid grid = make_grid(kBlock);
  ASSERT_EQ(grid.x.size(), 20u);
  ASSERT_EQ(grid.zones.size(), 12u);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) EXPECT_DOUBLE_EQ(area(corners(grid, z)), 0.5);
  EXPECT_EQ(grid.x.back(), 3);
  EXPECT_EQ(grid.y.back(), 2);
}

// Linear weights are integrated exactly: every zone, whatever its shape, gets the weight of its centroid.
TEST(Weights, LinearWeightsGiveTheCentroidsWeight) {
  const Grid grid = distorted_grid(kBlock);
  const auto linear = [](double x, double y) { return 0.5 + 0.1 * x - 0.05 * y; };
  const auto weights = zone_weights(grid, sampled(grid, linear), 1e-3);
  for (std::size_t z = 0; z < weights.size(); ++z) {
    const auto [x, y] = centroid(corners(grid, z));
    EXPECT_NEAR(weights[z], linear(x, y), 1e-15);
  }
}

// Zones whose samples are all 0 vanish, a zone with the slightest weight gets the floor.
TEST(Weights, ZonesWithoutWeightVanishAndOthersKeepTheFloor) {
  const auto ramp = [](double x, double) { return std::max(0.0, 1e-6 * (1.001 - x)); };
  Grid grid = make_grid(kBlock);
  auto weights = zone_weights(grid, sampled(grid, ramp), 1e-3);
  compact(grid, weights);
  ASSERT_EQ(grid.zones.size(), 9u);  // the column that begins at x = 1 m has samples of 1e-9
  EXPECT_EQ(grid.x.size(), 16u);
  for (const double weight : weights) EXPECT_EQ(weight, 1e-3);
  EXPECT_LE(*std::ranges::max_element(grid.x), 2);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) EXPECT_DOUBLE_EQ(area(corners(grid, z)), 0.5);
}

// The masses of the points are all of the mass, each zone's share weighted.
TEST(Masses, SumToTheWeightedMass) {
  const Grid grid = distorted_grid({0, 4, 0, 2, 8, 5});
  const auto masses = lumped_masses(grid, std::vector<double>(grid.zones.size(), 0.25), 2500);
  EXPECT_NEAR(std::accumulate(masses.begin(), masses.end(), 0.0), 0.25 * 2500 * 8, 1e-9);
}

// Equal zones in a row share one shape and one run; a distorted grid has one shape a zone.
TEST(Layout, RowsOfEqualZonesAreRuns) {
  const auto regular = lay_out(make_grid({0.1, 7.3, 0, 1, 37, 3}));
  EXPECT_EQ(regular.runs.size(), 3u);
  EXPECT_EQ(regular.shapes.size(), 1u);
  const auto distorted = lay_out(distorted_grid({0, 1, 0, 1, 4, 4}));
  EXPECT_EQ(distorted.shapes.size(), 16u);
}

}  // namespace
}  // namespace adit::fdm::test::grid_test
