// Bond stiffnesses of the hexagonal lattice that deforms like an elastic solid.
//
// One cell holds three bonds in the directions 0, 60 and 120 degrees. Under a uniform strain, bond b of
// length 2R and direction n, t stores kn (2R n.e.n)^2 / 2 + ks (2R t.e.n)^2 / 2 (spins free: they follow the
// mean rotation, so that only the symmetric strain e shears a bond). Summed over the three directions and
// divided by the cell's area 2 sqrt(3) R^2 this is an isotropic solid of unit thickness with
//   lambda + 2 mu = sqrt(3)/4 (3 kn + ks),   mu = sqrt(3)/4 (kn + ks),   lambda = sqrt(3)/4 (kn - ks),
// hence kn = 2/sqrt(3) (mu + lambda) and ks = 2/sqrt(3) (mu - lambda). In plane stress lambda = E nu / (1 -
// nu^2); plane strain is plane stress with E / (1 - nu^2) and nu / (1 - nu).
#pragma once

#include "dem_server/laws/contact_bond.hpp"

namespace adit::dem {

enum class Plane { kStrain, kStress };

// The shear stiffness is negative above largest_poisson_ratio.
BondStiffness calibrate(double young_modulus, double poisson_ratio, Plane plane);

// Of a solid of cells (engines/general/facets/facet_kernel.hpp): E' = 2 G and lambda of the plane [Pa].
struct CellElasticity {
  double stiffness, lambda;
};
CellElasticity cell_elasticity(double young_modulus, double poisson_ratio, Plane plane);

// Above it the lattice would need a negative shear stiffness: 1/3 in plane stress, 1/4 in plane strain.
double largest_poisson_ratio(Plane plane);

// Mass of one particle: that of its hexagonal cell, 2 sqrt(3) R^2 [kg per metre of thickness].
double cell_mass(double density, double radius);

}  // namespace adit::dem
