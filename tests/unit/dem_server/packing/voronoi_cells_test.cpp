#include "dem_server/packing/voronoi/voronoi_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "protocol/motion/random.hpp"

namespace adit::dem::voronoi_cells_test {
namespace {

using geometry::BoundingBox;
using geometry::Point;

std::vector<Point> random_points(std::size_t count, const BoundingBox& box, std::uint64_t seed) {
  motion::Random random(seed);
  std::vector<Point> points(count);
  for (auto& [x, y] : points) {
    x = box.x_min + (box.x_max - box.x_min) * random.uniform();
    y = box.y_min + (box.y_max - box.y_min) * random.uniform();
  }
  return points;
}

double total_area(const VoronoiCells& cells) {
  return std::accumulate(cells.area.begin(), cells.area.end(), 0.0);
}

const BoundingBox kBox{100, 103, -52, -50};  // far from the origin

// The cells fill the box: their areas sum to its area, whatever the number of points.
TEST(VoronoiCells, FillTheBox) {
  for (const std::size_t count : {1u, 2u, 3u, 10u, 5000u})
    EXPECT_NEAR(total_area(voronoi_cells(random_points(count, kBox, count), kBox)), 6, 6e-12) << count;
  EXPECT_EQ(voronoi_cells({}, kBox).size(), 0u);
}

// A facet is a piece of the bisector: its ends are as far from one nucleus as from the other, and the first
// cell lies on its left. Facets are ascending.
TEST(VoronoiCells, FacetsLieOnBisectors) {
  const auto cells = voronoi_cells(random_points(2000, kBox, 3), kBox);
  for (const auto& [i, j, x_1, y_1, x_2, y_2] : cells.facets) {
    const double way_x = cells.x[j] - cells.x[i], way_y = cells.y[j] - cells.y[i];
    const double distance = std::hypot(way_x, way_y);
    EXPECT_LT(i, j);
    for (const auto& [x, y] : {Point{x_1, y_1}, Point{x_2, y_2}}) {
      const double from_middle =
          (x - (cells.x[i] + cells.x[j]) / 2) * way_x + (y - (cells.y[i] + cells.y[j]) / 2) * way_y;
      EXPECT_NEAR(from_middle / distance, 0, 1e-12);
    }
    EXPECT_NEAR((way_x * (x_2 - x_1) + way_y * (y_2 - y_1)) / distance, 0, 1e-12);
    EXPECT_GT(way_x * (y_2 - y_1) - way_y * (x_2 - x_1), 0);
  }
  EXPECT_TRUE(
      std::ranges::is_sorted(cells.facets, {}, [](const Facet& f) { return std::pair(f.first, f.second); }));
  EXPECT_TRUE(std::ranges::is_sorted(cells.outer, {}, &OuterFace::cell));
}

struct Sums {
  double normal_x = 0, normal_y = 0, area = 0;
  void add(double from_x, double from_y, double to_x, double to_y) {  // about the nucleus, counter-clockwise
    normal_x += to_y - from_y;
    normal_y -= to_x - from_x;
    area += (from_x * to_y - from_y * to_x) / 2;
  }
};

// Facets and outer faces close around each cell: their normals times lengths sum to zero, and the triangles
// from the nucleus to its area (what a uniform stress needs to be in equilibrium).
TEST(VoronoiCells, FacesCloseAroundEachCell) {
  const auto cells = voronoi_cells(random_points(2000, kBox, 4), kBox);
  std::vector<Sums> sums(cells.size());
  const auto add = [&](std::uint32_t i, double x_1, double y_1, double x_2, double y_2) {
    sums[i].add(x_1 - cells.x[i], y_1 - cells.y[i], x_2 - cells.x[i], y_2 - cells.y[i]);
  };
  for (const auto& [i, j, x_1, y_1, x_2, y_2] : cells.facets) {
    add(i, x_1, y_1, x_2, y_2);
    add(j, x_2, y_2, x_1, y_1);
  }
  for (const auto& [i, x_1, y_1, x_2, y_2] : cells.outer) add(i, x_1, y_1, x_2, y_2);
  const double sliver = 1e-6 * std::sqrt(6.0 / 2000);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_NEAR(sums[i].normal_x, 0, 2 * sliver);
    EXPECT_NEAR(sums[i].normal_y, 0, 2 * sliver);
    EXPECT_NEAR(sums[i].area, cells.area[i], 1e-6 * cells.area[i]);
  }
}

// Each facet's middle has its two nuclei as the nearest ones, and each pair of points whose bisector has a
// piece nearer to both than to all others has a facet: compared with a search through all points.
TEST(VoronoiCells, NeighboursAreTheNearestOnes) {
  const auto points = random_points(300, kBox, 5);
  const auto cells = voronoi_cells(points, kBox);
  const auto square = [&](std::size_t k, double x, double y) {
    return (points[k].x - x) * (points[k].x - x) + (points[k].y - y) * (points[k].y - y);
  };
  for (const auto& [i, j, x_1, y_1, x_2, y_2] : cells.facets)
    for (std::size_t k = 0; k < points.size(); ++k)
      EXPECT_GT(square(k, (x_1 + x_2) / 2, (y_1 + y_2) / 2) * (1 + 1e-9),
                square(i, (x_1 + x_2) / 2, (y_1 + y_2) / 2));
  // Every corner of a cell is as near to its nucleus as to any other.
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t c = cells.corner_starts[i]; c < cells.corner_starts[i + 1]; ++c)
      for (std::size_t k = 0; k < points.size(); ++k)
        EXPECT_GT(square(k, cells.corner_x[c], cells.corner_y[c]) + 1e-12,
                  square(i, cells.corner_x[c], cells.corner_y[c]));
}

// In a square lattice, four cells meet in every corner: they are squares with four facets, and the cells that
// touch in a corner only share none.
TEST(VoronoiCells, SquaresMeetInCorners) {
  std::vector<Point> points;
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 9; ++i) points.push_back({0.05 + 0.1 * i, 0.05 + 0.1 * j});
  const auto cells = voronoi_cells(points, {0, 0.9, 0, 0.7});
  EXPECT_EQ(cells.facets.size(), 8u * 7 + 9 * 6);
  EXPECT_EQ(cells.outer.size(), 2u * (9 + 7));
  EXPECT_EQ(cells.corner_x.size(), 4u * 63);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_NEAR(cells.area[i], 0.01, 1e-15);
    EXPECT_NEAR(cells.polar_moment[i], 1e-4 / 6, 1e-17);  // a^4 / 6
    EXPECT_NEAR(cells.radius[i], 0.05, 1e-15);
  }
}

// In a hexagonal lattice, the inner cells are regular hexagons with sides d / sqrt(3).
TEST(VoronoiCells, HexagonsAreRegular) {
  std::vector<Point> points;
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) points.push_back({i + 0.5 * (j % 2), j * std::numbers::sqrt3 / 2});
  const auto cells = voronoi_cells(points, {-1, 10, -1, 9});
  const std::size_t middle = 4 * 9 + 4;
  EXPECT_NEAR(cells.area[middle], std::numbers::sqrt3 / 2, 1e-14);
  EXPECT_NEAR(cells.polar_moment[middle], 5 * std::numbers::sqrt3 / 72, 1e-14);  // 5 sqrt(3) / 8 side^4
  EXPECT_EQ(cells.corner_starts[middle + 1] - cells.corner_starts[middle], 6u);
  for (const auto& f : cells.facets)
    if (f.first == middle) {
      EXPECT_NEAR(std::hypot(f.x_2 - f.x_1, f.y_2 - f.y_1), 1 / std::numbers::sqrt3, 1e-14);
    }
}

// Points on a line share parallel facets from side to side; one point has the box for itself, from its side
// even.
TEST(VoronoiCells, FewPointsAndPointsOnALine) {
  const std::vector<Point> line{{100.5, -51.5}, {101, -51}, {101.5, -50.5}};
  const auto cells = voronoi_cells(line, kBox);
  ASSERT_EQ(cells.facets.size(), 2u);
  EXPECT_NEAR(total_area(cells), 6, 1e-12);
  EXPECT_EQ(cells.facets[0].second, 1u);
  const std::vector<Point> one{{100, -51}};
  const auto alone = voronoi_cells(one, kBox);
  EXPECT_TRUE(alone.facets.empty());
  EXPECT_EQ(alone.outer.size(), 4u);
  EXPECT_NEAR(alone.area[0], 6, 1e-13);
  EXPECT_NEAR(alone.polar_moment[0], 6 * (9.0 / 3 + 4.0 / 12), 1e-12);
  EXPECT_EQ(alone.radius[0], 0);
}

// Points that coincide, points outside and a box without area are refused, with the numbers of the points.
TEST(VoronoiCells, RefusesWhatHasNoCells) {
  const auto message = [](const std::vector<Point>& points, const BoundingBox& box) {
    try {
      voronoi_cells(points, box);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message({{1, 1}, {0, 0}, {1, 1}}, {0, 2, 0, 2}),
            "points 0 and 2 of a diagram of cells coincide at (1, 1)");
  EXPECT_EQ(message({{1, 1}, {3, 0}}, {0, 2, 0, 2}),
            "point 1 of a diagram of cells, (3, 0), lies outside the box");
  EXPECT_EQ(message({{1, 1}}, {0, 2, 1, 1}), "the box of a diagram of cells has no area");
}

}  // namespace
}  // namespace adit::dem::voronoi_cells_test
