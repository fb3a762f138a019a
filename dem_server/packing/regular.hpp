// Hexagonal packing of equal discs in a box.
#pragma once

#include "dem_server/packing/discs.hpp"
#include "protocol/geometry/bounding_box.hpp"

namespace adit::dem {

struct HexagonalLattice {
  Discs discs;                  // row by row from below, each row from left to right
  geometry::BoundingBox cells;  // extent of the hexagonal cells' rows [m]
};

// Rows are sqrt(3) R high and centred in the box, as many as fit; the first, third, … hold as many discs as
// fit, centred; those between hold one less, shifted by R. A box that holds no disc gives no particles.
HexagonalLattice pack_hexagonally(const geometry::BoundingBox& box, double radius);

// Number of particles that pack_hexagonally would make, as a double: cannot overflow.
double count_hexagonal(const geometry::BoundingBox& box, double radius);

// Square packing of equal discs in a box: columns above columns, each disc touching four.
// As many columns and rows 2 R wide as fit, centred in the box; row by row from below, each from left to
// right.
Discs pack_squarely(const geometry::BoundingBox& box, double radius);

}  // namespace adit::dem
