#include "dem_server/packing/voronoi/cell_points.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>
#include <stdexcept>

#include "dem_server/packing/voronoi/voronoi_cells.hpp"
#include "protocol/geometry/polygon.hpp"

namespace adit::dem::cell_points_test {
namespace {

using geometry::BoundingBox;
using geometry::Point;

const BoundingBox kBox{-4, 4, -4, 4};
constexpr double kPi = std::numbers::pi;

VoronoiCells cells_of(const CellPacking& wanted) {
  return voronoi_cells(pack_cells(wanted), wanted.box);
}

// Area of the cells whose nuclei the shape holds.
double area_where(const VoronoiCells& cells, const std::function<bool(double, double)>& holds) {
  double sum = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (holds(cells.x[i], cells.y[i])) sum += cells.area[i];
  return sum;
}

double area_in_circle(const VoronoiCells& cells, double radius) {
  return area_where(cells, [radius](double x, double y) { return std::hypot(x, y) < radius; });
}

double area_in_loop(const VoronoiCells& cells, const geometry::Loop& loop) {
  const auto sides = geometry::sides(loop);
  return area_where(cells, [&](double x, double y) { return geometry::signed_distance(sides, {x, y}) < 0; });
}

double least_distance(const std::vector<Point>& points) {
  double least = 1e300;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, std::hypot(points[i].x - points[j].x, points[i].y - points[j].y));
  return least;
}

// No cell crosses a circle but by the sagitta of the widest facet on it, and those inside have its area.
TEST(CellPoints, CellsEndAtACircle) {
  const double radius = 3, size = 0.1, sagitta = 1.3 * 1.3 * size * size / (8 * radius);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto cells = cells_of({kBox, size, {FaceCircle{{0, 0}, radius}}, seed});
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const bool inside = std::hypot(cells.x[i], cells.y[i]) < radius;
      for (std::size_t c = cells.corner_starts[i]; c < cells.corner_starts[i + 1]; ++c) {
        const double from_centre = std::hypot(cells.corner_x[c], cells.corner_y[c]);
        if (inside)
          EXPECT_LT(from_centre, radius + sagitta);
        else
          EXPECT_GT(from_centre, radius - sagitta);
      }
    }
    EXPECT_NEAR(area_in_circle(cells, radius), kPi * radius * radius, 1e-11);
  }
}

// The cells between two circles have the area of the ring: its mean thickness is exact, from half a size on,
// with as many rows of cells as fit.
TEST(CellPoints, RingsHaveTheirThickness) {
  const double outer = 3, size = 0.1;
  for (const double sizes : {0.5, 0.8, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0}) {
    const double inner = outer - sizes * size;
    const auto cells = cells_of({kBox, size, {FaceCircle{{0, 0}, outer}, FaceCircle{{0, 0}, inner}}, 5});
    EXPECT_NEAR(area_in_circle(cells, outer), kPi * outer * outer, 1e-11) << sizes;
    EXPECT_NEAR(area_in_circle(cells, inner), kPi * inner * inner, 1e-11) << sizes;
  }
}

// A ring two sizes thick is two rows of cells, each beside one face; one of three sizes has a row between.
TEST(CellPoints, RingsHaveRowsOfCells) {
  const auto cells_per_size = [](double thickness) {
    const auto points =
        pack_cells({kBox, 0.1, {FaceCircle{{0, 0}, 3}, FaceCircle{{0, 0}, 3 - thickness}}, 2});
    double in_ring = 0;
    for (const auto& [x, y] : points)
      if (std::hypot(x, y) < 3 && std::hypot(x, y) > 3 - thickness) ++in_ring;
    return in_ring / (2 * kPi * (3 - thickness / 2) / 0.0866);
  };
  EXPECT_NEAR(cells_per_size(0.2), 2, 0.02);
  EXPECT_NEAR(cells_per_size(0.3), 3, 0.15);
}

// Polygons keep their areas and so their corners, which may be right, blunt, sharp or turned inwards, and may
// have short sides.
TEST(CellPoints, CornersAreExact) {
  const std::vector<geometry::Loop> loops{
      {{-2, -1}, {2, -1}, {2, 1.5}, {-2, 1.5}},                        // a box
      {{-2.1, -1}, {1.7, -2}, {1.9, 1.5}, {-1.2, 1.7}},                // all angles near 90 degrees
      {{-2, -2}, {2, -2}, {0, -2 + 2 * std::numbers::sqrt3}},          // 60 degrees
      {{-2, -2}, {2, -2}, {2, 2}, {0.5, 2}, {0.5, -0.5}, {-2, -0.5}},  // an L
      {{-3, 0}, {0, -1.2}, {3, 0}, {0, 1.2}},                          // 44 degrees
      {{-2, -2}, {2, -2}, {2.4, 0.3}, {2, 2}, {-2, 2}, {-2.2, 0}},     // bends by 20 and 11 degrees
      {{-2, -2}, {-1.85, -2}, {-1.85, 2}, {-2, 2}},                    // a strip of 1.5 sizes
  };
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto& loop = loops[k];
      double area = 0;
      for (const auto& [a, b] : geometry::sides(loop)) area += (a.x * b.y - a.y * b.x) / 2;
      const auto cells = cells_of({kBox, 0.1, {FaceLine{loop, true}}, seed});
      EXPECT_NEAR(area_in_loop(cells, loop), area, 1e-9) << "loop " << k << ", seed " << seed;
    }
}

// An oval of many short sides keeps its area but for what chords cut off.
TEST(CellPoints, FinelyBentLinesAreFollowed) {
  geometry::Loop oval;
  for (int k = 0; k < 360; ++k) oval.push_back({3 * std::cos(k * kPi / 180), 2 * std::sin(k * kPi / 180)});
  const auto cells = cells_of({kBox, 0.2, {FaceLine{oval, true}}, 1});
  EXPECT_NEAR(area_in_loop(cells, oval), 6 * kPi, 2e-3 * 6 * kPi);
}

// An oblique line from side to side divides the box: no cell crosses it but near its ends.
TEST(CellPoints, LinesFromSideToSideDivide) {
  const double size = 0.1, slope = 0.4;
  const auto cells = cells_of({kBox, size, {FaceLine{{{-4, -4 * slope}, {4, 4 * slope}}}}, 3});
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t c = cells.corner_starts[i]; c < cells.corner_starts[i + 1]; ++c) {
      if (std::abs(cells.corner_x[c]) > 4 - 1.5 * size) continue;
      const double above = cells.y[i] > slope * cells.x[i] ? 1 : -1;
      EXPECT_GT(above * (cells.corner_y[c] - slope * cells.corner_x[c]), -1e-12);
    }
}

// The mean area of cells is that of a hexagonal lattice of the packing's size, within 2 %.
TEST(CellPoints, CellsHaveTheMeanAreaAskedFor) {
  const std::vector<std::vector<CellFace>> faces{{},
                                                 {FaceCircle{{0, 0}, 3}, FaceCircle{{0, 0}, 2.7}},
                                                 {FaceLine{{{-2, -1}, {2, -1}, {2, 1.5}, {-2, 1.5}}, true}}};
  for (const double size : {0.1, 0.15})
    for (const auto& chosen : faces) {
      const double count = static_cast<double>(pack_cells({kBox, size, chosen, 4}).size());
      EXPECT_NEAR(64 / count, std::numbers::sqrt3 / 2 * size * size, 0.02 * size * size);
    }
}

// Nuclei are not close to each other nor to the sides: small cells would cost small time steps.
TEST(CellPoints, NucleiKeepTheirDistance) {
  const auto points = pack_cells({kBox, 0.1, {FaceCircle{{0, 0}, 3}, FaceCircle{{0, 0}, 2.7}}, 6});
  EXPECT_GT(least_distance(points), 0.06);
  for (const auto& [x, y] : points) EXPECT_LE(std::max(std::abs(x), std::abs(y)), 4 - 0.025);
  EXPECT_GE(least_distance(pack_cells({kBox, 0.1, {}, 6})), 0.0777);
}

// The filling leaves no room: no place of the box is farther from the nearest nucleus than the least distance
// of nuclei, but for the strip along the sides.
TEST(CellPoints, NoRoomIsLeft) {
  const auto cells = cells_of({kBox, 0.1, {}, 7});
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t c = cells.corner_starts[i]; c < cells.corner_starts[i + 1]; ++c) {
      const double x = cells.corner_x[c], y = cells.corner_y[c];
      if (std::max(std::abs(x), std::abs(y)) > 4 - 0.025) continue;
      EXPECT_LE(std::hypot(x - cells.x[i], y - cells.y[i]), 0.0777 * (1 + 1e-6));
    }
}

// The length of the facets that lie on the line between two points.
double length_on(const VoronoiCells& cells, const Point& a, const Point& b, double size) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const Point along{(b.x - a.x) / length, (b.y - a.y) / length};
  double sum = 0;
  for (const Facet& f : cells.facets) {
    const auto aside = [&](double x, double y) {
      return std::abs(along.x * (y - a.y) - along.y * (x - a.x));
    };
    const auto place = [&](double x, double y) {
      return std::clamp(along.x * (x - a.x) + along.y * (y - a.y), 0.0, length);
    };
    if (std::max(aside(f.x_1, f.y_1), aside(f.x_2, f.y_2)) < 1e-9 * size)
      sum += std::abs(place(f.x_2, f.y_2) - place(f.x_1, f.y_1));
  }
  return sum;
}

// Smaller cells in a ring, from which sizes grow to four times as much.
CellPacking graded(double fine, double coarse, std::vector<CellFace> faces, std::uint64_t seed) {
  const auto from_ring = [](const Point& p) { return std::abs(std::hypot(p.x, p.y) - 2.85) - 0.15; };
  return {kBox, CellSize(coarse, {{from_ring, fine}}), std::move(faces), seed};
}

// In the ring, as far from it as cells have their largest size, and between, as many cells lie as the size of
// each place asks for; and neighbours are alike.
TEST(CellPoints, SizesGrowFromPlaceToPlace) {
  constexpr int kRings = 4;
  const auto ring_of = [](const Point& p) {
    const double distance = std::abs(std::hypot(p.x, p.y) - 2.85) - 0.15;
    return distance < 0.02 ? 0 : distance < 0.5 ? 1 : distance < 1.2 ? 2 : 3;
  };
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const CellPacking wanted = graded(0.1, 0.4, {FaceCircle{{0, 0}, 2.7}, FaceCircle{{0, 0}, 3}}, seed);
    const auto cells = cells_of(wanted);
    std::array<double, kRings> found{}, asked{};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double size = wanted.size.at({cells.x[i], cells.y[i]});
      const auto ring = static_cast<std::size_t>(ring_of({cells.x[i], cells.y[i]}));
      found[ring] += cells.area[i];
      asked[ring] += std::numbers::sqrt3 / 2 * size * size;
    }
    for (std::size_t ring = 0; ring < kRings; ++ring)
      EXPECT_NEAR(found[ring], asked[ring], 0.06 * asked[ring]) << ring;
    for (const Facet& f : cells.facets)
      EXPECT_LT(std::abs(std::log(cells.area[f.first] / cells.area[f.second])), std::log(4.5));
  }
}

// Faces are exact where sizes change along them, at their crossings and at the sides of the box.
TEST(CellPoints, FacesAcrossSizesAreExact) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const geometry::Loop block{{-3.6, -3.4}, {3.5, -3.4}, {3.5, -0.7}, {-3.6, -0.7}};
    const auto cells = cells_of(graded(0.1, 0.4,
                                       {FaceCircle{{0, 0}, 2.7}, FaceCircle{{0, 0}, 3},
                                        FaceLine{{{-3.8, -0.1}, {3.8, 1.9}}}, FaceLine{block, true}},
                                       seed));
    EXPECT_NEAR(area_in_circle(cells, 2.7), 2.7 * 2.7 * kPi, 1e-11) << seed;
    EXPECT_NEAR(area_in_circle(cells, 3), 9 * kPi, 1e-11) << seed;
    EXPECT_NEAR(area_in_loop(cells, block), 7.1 * 2.7, 1e-9) << seed;
    EXPECT_NEAR(length_on(cells, {-3.7, -0.1 + 0.1 * 2 / 7.6}, {3.7, 1.9 - 0.1 * 2 / 7.6}, 0.1),
                std::hypot(7.4, 7.4 * 2 / 7.6), 1e-9)
        << seed;
  }
}

// A finer place that reaches the sides is as fine there, and nuclei keep a quarter of the size from them.
TEST(CellPoints, FinerPlacesMayReachTheSides) {
  const auto right_half = [](const Point& p) { return -p.x; };
  const CellPacking wanted{kBox, CellSize(0.5, {{right_half, 0.1}}), {}, 3};
  const auto points = pack_cells(wanted);
  double right = 0;
  for (const Point& p : points) {
    const double from_sides = 4 - std::max(std::abs(p.x), std::abs(p.y));
    EXPECT_GE(from_sides, (1 - 1e-9) * wanted.size.at(p) / 4);
    if (p.x > 0) ++right;
  }
  EXPECT_NEAR(32 / right, std::numbers::sqrt3 / 2 * 0.01, 0.02 * 0.01);
}

// The same seed gives the same nuclei, another seed others.
TEST(CellPoints, DependOnTheSeedAlone) {
  CellPacking wanted{kBox, 0.2, {FaceCircle{{0, 0}, 3}}, 1};
  const auto first = pack_cells(wanted), again = pack_cells(wanted);
  wanted.seed = 2;
  const auto other = pack_cells(wanted);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].x, again[i].x);
    EXPECT_EQ(first[i].y, again[i].y);
  }
  EXPECT_NE(first[0].x, other[0].x);
  EXPECT_NE(first.back().x, other.back().x);
}

// Faces that cross, meet, touch the sides or leave the box give cells all the same, none of them tiny, and
// the face that is named first stays exact, even if others graze one another.
TEST(CellPoints, FacesMayMeet) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CellPacking wanted{
        kBox,
        0.1,
        {FaceCircle{{0, 0}, 3}, FaceCircle{{1, 1}, 2.5}, FaceCircle{{3, 3}, 2}, FaceLine{{{-4, -1}, {4, 1}}},
         FaceLine{{{0, -4}, {0, 0}}}, FaceLine{{{-4, -1.3}, {5, 1.2}}}, FaceLine{{{-4, -4}, {4, -4}, {4, 4}}},
         FaceCircle{{0.01, 0}, 3.001}},
        seed};
    const auto points = pack_cells(wanted);
    EXPECT_GT(least_distance(points), 0.015);
    EXPECT_NEAR(area_in_circle(voronoi_cells(points, kBox), 3), 9 * kPi, 1e-11);
    wanted.faces.push_back(FaceLine{{{-2.98, 0}, {-2.98, 3}}});  // grazes the first circle
    EXPECT_GT(least_distance(pack_cells(wanted)), 0.015);
  }
}

// The largest sum over a cell's facets of length / distance of the nuclei, over its area, in hexagonal cells:
// the critical time step goes with the inverse of its root.
double highest_stiffness(const VoronoiCells& cells, double size) {
  std::vector<double> sums(cells.size(), 0.0);
  for (const Facet& f : cells.facets) {
    const double ratio =
        std::hypot(f.x_2 - f.x_1, f.y_2 - f.y_1) /
        std::hypot(cells.x[f.second] - cells.x[f.first], cells.y[f.second] - cells.y[f.first]);
    sums[f.first] += ratio / cells.area[f.first];
    sums[f.second] += ratio / cells.area[f.second];
  }
  const double of_hexagon = 6 / std::numbers::sqrt3 / (std::numbers::sqrt3 / 2 * size * size);
  return *std::ranges::max_element(sums) / of_hexagon;
}

Point around(const Point& centre, double radius, double degrees) {
  return {centre.x + radius * std::cos(degrees * kPi / 180),
          centre.y + radius * std::sin(degrees * kPi / 180)};
}

// Radial joints of a lining are edges of cells over its whole thickness, whether they end on its circles, a
// hundredth of a cell before them or half a cell beyond; and the circles keep their areas.
TEST(CellPoints, RadialJointsAreExact) {
  const double size = 0.1;
  for (const double cells_thick : {2.0, 2.5, 3.0, 5.0})
    for (const double beyond : {0.0, -0.01, 0.5})
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const double inner = 3 - cells_thick * size;
        CellPacking wanted{kBox, size, {FaceCircle{{0, 0}, inner}, FaceCircle{{0, 0}, 3}}, seed};
        for (int k = 0; k < 7; ++k)
          wanted.faces.push_back(FaceLine{
              {around({0, 0}, inner - beyond * size, 51 * k), around({0, 0}, 3 + beyond * size, 51 * k)}});
        const auto cells = cells_of(wanted);
        for (int k = 0; k < 7; ++k)
          EXPECT_NEAR(length_on(cells, around({0, 0}, inner, 51 * k), around({0, 0}, 3, 51 * k), size),
                      cells_thick * size, 1e-9 * size)
              << cells_thick << " cells, " << beyond << " beyond, joint " << k << ", seed " << seed;
        EXPECT_NEAR(area_in_circle(cells, 3), 9 * kPi, 1e-11);
        EXPECT_NEAR(area_in_circle(cells, inner), inner * inner * kPi, 1e-11);
        EXPECT_LT(highest_stiffness(cells, size), 2);
      }
}

// A line through the centre of a lining crosses both circles, and all three are exact.
TEST(CellPoints, LinesThatCrossCirclesAreExact) {
  const double size = 0.1;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto cells = cells_of(
        {kBox, size, {FaceCircle{{0, 0}, 3}, FaceCircle{{0, 0}, 2.6}, FaceLine{{{-4, -1}, {4, 1}}}}, seed});
    EXPECT_NEAR(length_on(cells, {-3.5, -0.875}, {3.5, 0.875}, size), std::hypot(7, 1.75), 1e-9);
    EXPECT_NEAR(area_in_circle(cells, 3), 9 * kPi, 1e-11);
    EXPECT_NEAR(area_in_circle(cells, 2.6), 2.6 * 2.6 * kPi, 1e-11);
  }
}

struct Rays {
  double direction;  // [degrees]
  bool through;      // the point, or from it on
};

// Lines through one point, and lines that end in it, are all exact down to 35 degrees between them, and no
// cell needs a time step of less than half of a hexagonal one's.
TEST(CellPoints, JunctionsAreExact) {
  const std::vector<std::vector<Rays>> junctions{
      {{0, true}, {90, true}},
      {{0, true}, {75, true}},
      {{0, true}, {60, true}},
      {{0, true}, {45, true}},
      {{0, true}, {35, true}},
      {{0, true}, {90, false}},
      {{0, true}, {60, false}},
      {{0, true}, {45, false}},
      {{0, true}, {60, true}, {120, true}},
      {{0, true}, {90, true}, {45, false}},
      {{0, false}, {120, false}, {240, false}},
      {{0, false}, {90, false}},
      {{0, false}, {180, false}},
  };
  const Point middle{0.1, 0.07};
  for (const double size : {0.1, 0.23})
    for (std::size_t j = 0; j < junctions.size(); ++j)
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        CellPacking wanted{kBox, size, {}, seed};
        const double turned = 21 * static_cast<double>(seed);
        const auto from = [&](const Rays& rays, double length) {
          return rays.through ? around(middle, -length, turned + rays.direction) : middle;
        };
        for (const Rays& rays : junctions[j])
          wanted.faces.push_back(FaceLine{{from(rays, 3), around(middle, 3, turned + rays.direction)}});
        const auto cells = cells_of(wanted);
        for (const Rays& rays : junctions[j])
          EXPECT_NEAR(length_on(cells, from(rays, 2), around(middle, 2, turned + rays.direction), size),
                      rays.through ? 4 : 2, 1e-9)
              << "junction " << j << ", " << rays.direction << " degrees, size " << size << ", seed " << seed;
        EXPECT_LT(highest_stiffness(cells, size), 4);
      }
}

// Boxes that share a piece of a side, and boxes that cross, keep their areas.
TEST(CellPoints, BoxesThatShareASideOrCrossAreExact) {
  const geometry::Loop lower{{-2, -2}, {2, -2}, {2, 0}, {-2, 0}}, upper{{-2, 0}, {2, 0}, {2, 2}, {-2, 2}},
      beside{{2, -1}, {3.2, -1}, {3.2, 1.1}, {2, 1.1}}, across{{-3, -1}, {0.5, -1}, {0.5, 1}, {-3, 1}};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto cells = cells_of(
        {kBox,
         0.1,
         {FaceLine{lower, true}, FaceLine{upper, true}, FaceLine{beside, true}, FaceLine{across, true}},
         seed});
    EXPECT_NEAR(area_in_loop(cells, lower), 8, 1e-9);
    EXPECT_NEAR(area_in_loop(cells, upper), 8, 1e-9);
    EXPECT_NEAR(area_in_loop(cells, beside), 2.52, 1e-9);
    EXPECT_NEAR(area_in_loop(cells, across), 7, 1e-9);
  }
}

// A box that is smaller than a cell has one.
TEST(CellPoints, SmallBoxesHaveACell) {
  EXPECT_EQ(pack_cells({{0, 0.1, 0, 0.1}, 1, {}, 1}).size(), 1u);
  EXPECT_GE(pack_cells({{0, 10, 0, 0.1}, 1, {}, 1}).size(), 5u);
}

// What cannot be packed is refused with the number of the face.
TEST(CellPoints, RefusesWhatCannotBePacked) {
  const auto message = [](const CellPacking& wanted) {
    try {
      pack_cells(wanted);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message({kBox, 0, {}, 1}), "the size of cells is 0, not positive");
  EXPECT_EQ(message({{0, 0, 0, 1}, 1, {}, 1}), "the box of a packing of cells has no finite area");
  const std::string bad =
      " of a packing of cells is neither a line that does not meet itself nor a circle with a radius of at "
      "least 0.5 m, half the size of a cell";
  EXPECT_EQ(message({kBox, 1, {FaceCircle{{0, 0}, 0.5}, FaceCircle{{0, 0}, 0.49}}, 1}), "face 1" + bad);
  EXPECT_EQ(message({kBox, 1, {FaceLine{{{0, 0}}}}, 1}), "face 0" + bad);
  EXPECT_EQ(message({kBox, 0.1, {FaceCircle{{0, 0}, 3}, FaceLine{{{-4, -3.03}, {4, -3.03}}}}, 1}),
            "faces 0 and 1 of a packing of cells are less than 0.05 m apart, half the size of a cell, but "
            "meet nowhere");
  EXPECT_EQ(message({kBox, 1, {FaceLine{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, true}}, 1}), "face 0" + bad);
}

// A hundred thousand cells are made in seconds; the time is told, since it depends on the machine.
TEST(CellPoints, AHundredThousandCells) {
  const auto start = std::chrono::steady_clock::now();
  const auto cells = cells_of({{0, 10, 0, 10}, std::sqrt(1e-3 / 0.866), {FaceCircle{{5, 5}, 3}}, 1});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::cout << cells.size() << " cells in " << took.count() << " s\n";
  EXPECT_NEAR(static_cast<double>(cells.size()), 1e5, 2e3);
}

}  // namespace
}  // namespace adit::dem::cell_points_test
