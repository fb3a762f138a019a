// Hexagonal packing of equal discs in a box: where the particles are and which of them touch.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace adit::dem {

struct Rectangle {
  double x_min, x_max, y_min, y_max;  // [m]
};

// Direction of a bond at rest, from its first to its second particle.
enum class Direction : std::uint8_t { kAlongRow, kUpRight, kUpLeft };

struct Link {
  std::uint32_t first, second;  // particles; second is right of or above first
  Direction direction;
};

struct Packing {
  double radius;             // [m]
  Rectangle cells;           // extent of the hexagonal cells' rows [m]
  std::vector<double> x, y;  // centres, row by row from below, each row from left to right [m]
  std::vector<Link> links;   // by row, then by direction, then from left to right
};

// Rows are sqrt(3) R high and centred in the box, as many as fit; the first, third, … hold as many discs as
// fit, centred; those between hold one less, shifted by R. A box that holds no disc gives no particles.
Packing pack_hexagonally(const Rectangle& box, double radius);

// Number of particles that pack_hexagonally would make, as a double: cannot overflow.
double count_hexagonal(const Rectangle& box, double radius);

// Vector from the first to the second particle of a bond at rest [m].
std::array<double, 2> rest_vector(Direction direction, double radius);

}  // namespace adit::dem
