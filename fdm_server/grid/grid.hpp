// The grid: points, and zones of four points each, counter-clockwise.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace adit::fdm {

using ZonePoints = std::array<std::int32_t, 4>;

struct Grid {
  std::vector<double> x, y;  // of each point [m]
  std::vector<ZonePoints> zones;
};

// Corner coordinates of a zone [m].
struct Corners {
  std::array<double, 4> x, y;
};
Corners corners(const Grid& grid, const ZonePoints& zone);
double area(const Corners& corners);  // [m^2], positive where the corners run counter-clockwise

// A rectangle of equal zones.
struct Block {
  double x_min, x_max, y_min, y_max;  // [m]
  std::uint32_t zones_x, zones_y;
};

// Points row by row from the lower left corner, zones likewise.
Grid make_grid(const Block& block);

// The points at which the energy weight is sampled: the lattice of half zones, (2 zones_x + 1) x
// (2 zones_y + 1) points, row by row from the lower left corner, interleaved x0 y0 x1 y1 … [m]. Zone (i, j)
// owns the 3 x 3 of them that start at column 2 i, row 2 j: corners, mid-edges, centre.
std::vector<double> sample_points(const Block& block);

// Weight of each zone from the samples: their mean by Simpson's rule, exact for linear weights, so that a
// patch of uniform strain passes through the overlap; at least `floor`. A zone whose samples are all 0 has 0.
std::vector<double> zone_weights(const Block& block, std::span<const double> samples, double floor);

// Removes zones of weight 0 (also from `weights`) and the points that no zone is left of; keeps the order.
void compact(Grid& grid, std::vector<double>& weights);

// Weighted lumped mass of each point: a quarter of each of its zones' [kg per metre of thickness].
std::vector<double> lumped_masses(const Grid& grid, std::span<const double> weights, double density);
std::vector<double> lumped_masses(const Grid& grid, std::span<const double> weights,
                                  std::span<const double> densities);  // of each zone

}  // namespace adit::fdm
