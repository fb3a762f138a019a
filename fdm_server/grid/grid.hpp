// The grid: points, and zones of four points each, counter-clockwise.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "protocol/geometry/bounding_box.hpp"

namespace adit::fdm {

using ZonePoints = std::array<std::int32_t, 4>;

// Corner coordinates of a zone [m].
struct Corners {
  std::array<double, 4> x, y;
};

// A side of a zone, which lies on its left.
struct Edge {
  std::int32_t from, to;  // points
  std::uint32_t zone;
};

// What the user gave a name: a block, a physical group of a mesh. A curve's edges may lie inside the grid;
// their zone is that of one side.
struct Group {
  std::string name;
  std::vector<std::uint32_t> zones;  // ascending
  std::vector<Edge> edges;
};

struct Grid {
  std::vector<double> x, y;  // of each point [m]
  std::vector<ZonePoints> zones;
  std::vector<Edge>
      boundary{};  // sides of one zone only; not those that appear where zones without weight vanish
  std::vector<Group> groups{};
  // Shapes of the last zones, where they are not those of their points: a column whose left and right points
  // are the same has a width all the same.
  std::vector<Corners> own_corners{};
  std::uint32_t column_points = 0;  // the last points
  // Before them lie points that share the place of another (cut.hpp, linings with an interface): that one.
  std::vector<std::uint32_t> double_of{};

  // Without the columns'.
  std::size_t own_points() const { return x.size() - column_points; }
  // One at each place.
  std::size_t places() const { return own_points() - double_of.size(); }
  // The first point at the place of an own one.
  std::uint32_t place(std::uint32_t point) const {
    return point < places() || point >= own_points() ? point : double_of[point - places()];
  }
  std::size_t own_zones() const { return zones.size() - own_corners.size(); }
};

Corners corners(const Grid& grid, std::size_t zone);
double area(const Corners& corners);  // [m^2], positive where the corners run counter-clockwise
std::array<double, 2> centroid(const Corners& corners);

geometry::BoundingBox bounds(const Grid& grid);
// Within which places count as the same: 1e-9 of the grid's diagonal [m].
double tolerance(const Grid& grid);

// A rectangle of equal zones.
struct Block {
  double x_min, x_max, y_min, y_max;  // [m]
  std::uint32_t zones_x, zones_y;
};

// Points row by row from the lower left corner, zones likewise.
Grid make_grid(const Block& block);

// Removes zones of weight 0 (also from `weights`), their edges and the points that no zone is left of; keeps
// the order. Before zones with corners of their own are added.
void compact(Grid& grid, std::vector<double>& weights);

// Weighted lumped mass of each point: a quarter of each of its zones' [kg per metre of thickness].
std::vector<double> lumped_masses(const Grid& grid, std::span<const double> weights, double density);
std::vector<double> lumped_masses(const Grid& grid, std::span<const double> weights,
                                  std::span<const double> densities);  // of each zone

}  // namespace adit::fdm
