// How fast waves that are long beside the particles run in a bonded model, from the stiffness of its bonds.
//
// A plane wave of direction e and unit polarisation a strains all bonds alike, by sym(e a). A bond of length
// L and direction n (t its normal) stretches by L (e.n)(a.n) and shears by L ((e.n)(a.t) + (e.t)(a.n)) / 2,
// because spins follow the mean rotation (calibration.hpp). Half of its stiffness belongs to each of its
// particles, whose mass is m:
//   c^2 = 1/(2 m) sum over the bonds of L^2 (kn (e.n)^2 (a.n)^2 + ks ((e.n)(a.t) + (e.t)(a.n))^2 / 4),
// a = e for the compression wave, a normal to e for the shear wave. For the hexagonal lattice this is exact,
// c_p^2 = sqrt(3)/4 (3 kn + ks) / density and c_s^2 = sqrt(3)/4 (kn + ks) / density, and so is c_p along a
// single row. Cells add lambda / density to c_p^2, and have both speeds of their solid. Bonds of a random
// packing do not all strain alike: there the speeds are upper bounds (Voigt).
#pragma once

#include "dem_server/model/model.hpp"

namespace adit::dem {

struct WaveSpeeds {
  double p = 0, s = 0;  // [m/s]
};

// Speeds in the model at rest, by its bonds, joints and springs: those of the fastest group, in its fastest
// direction. The speed of a group is the median over its bonded particles, so that neither those on its edge
// nor a few odd ones count. 0 without bonds.
WaveSpeeds wave_speeds(const Model& model);

// Highest frequency that the model carries well [Hz]: that of which 10 particles, the largest of the group,
// are a wavelength of the group's shear waves, in the group where it is lowest. 0 without bonds that bear
// shear.
double highest_frequency(const Model& model);

}  // namespace adit::dem
