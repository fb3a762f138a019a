// The stress of the ground before anything acts, as forces in the bonds of a hexagonal lattice.
//
// The uniform strain e that gives the stress in the lattice (calibration.hpp) would load a bond of direction
// n, t with Fn = kn 2R n.e.n and Fs = ks 2R t.e.n. Forces of each bond from the stress at its middle balance
// on every particle inside where the stress is uniform, and carry the particles' weight where it grows by
// that.
#pragma once

#include "dem_server/model/calibration.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {

struct BondForces {
  double normal, shear;  // tension positive; on the first disc along its left normal [N]
};

struct RestBond {
  double x, y, length;  // from its first to its second disc [m]
  double height;        // y of its middle [m]
};

BondForces initial_forces(const InitialStress& stress, const BondStiffness& stiffness, const RestBond& bond);

}  // namespace adit::dem
