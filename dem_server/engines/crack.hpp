// Geometry of the crack that a broken bond leaves, in the body at rest: across the bond, where the particles
// touched.
//
// It is as long as a parallel bond is wide. A contact bond leaves the edge of the hexagonal cell of its
// smaller particle, 2 R / sqrt(3), so that the cracks around a particle that is cut off close and their
// lengths add up to a fracture's.
#pragma once

#include <cstdint>

#include "dem_server/laws/bond_state.hpp"
#include "dem_server/particles/particles.hpp"

namespace adit::dem {

struct Crack {
  BondState mode;
  double x, y;                             // where the particles touched [m]
  double length;                           // [m]
  double orientation;                      // of the crack's line, in (-pi/2, pi/2] [rad]
  std::uint32_t parent_a, parent_b;        // ids of the particles, ascending
  std::uint32_t group_a = 0, group_b = 0;  // of the particles, ascending
};

// `width` of a parallel bond [m]; 0: of a contact bond.
Crack crack_between(const Particles& particles, std::uint32_t first, std::uint32_t second, double width,
                    BondState mode);

// Of a line across a normal (nx, ny), brought into (-pi/2, pi/2] [rad].
double crack_orientation(double nx, double ny);

}  // namespace adit::dem
