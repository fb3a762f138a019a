// Geometry of the crack that a broken bond leaves, in the body at rest: the edge that the two hexagonal cells
// share, so that the cracks around a cut-off particle close and their lengths add up to a fracture's.
#pragma once

#include <cstdint>

#include "dem_server/particles/assembly.hpp"

namespace adit::dem {

struct Crack {
  BondState mode;
  double x, y;                       // where the particles touched [m]
  double length;                     // of the cells' common edge, 2 R / sqrt(3) [m]
  double orientation;                // of the edge, perpendicular to the bond, in (-pi/2, pi/2] [rad]
  std::uint32_t parent_a, parent_b;  // ids of the particles
};

struct Place {
  double x, y;  // [m]
};

// Where the particles of a bond touch at rest.
Place middle_of_bond(const Assembly& assembly, std::uint32_t bond);

Crack crack_of_bond(const Assembly& assembly, std::uint32_t bond);

}  // namespace adit::dem
