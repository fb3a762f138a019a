// The stress of the ground before anything acts, as forces in the bonds.
//
// The uniform strain e that gives the stress in the lattice (calibration.hpp) would load a bond of direction
// n, t with Fn = kn 2R n.e.n and Fs = ks 2R t.e.n. Forces of each bond from the stress at its middle balance
// on every particle inside where the stress is uniform, and carry the particles' weight where it grows by
// that.
#pragma once

#include "dem_server/model/calibration.hpp"
#include "dem_server/particles/assembly.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

void set_initial_stress(const scene::Stress& stress, const BondStiffness& stiffness, Assembly& assembly);

}  // namespace adit::dem
