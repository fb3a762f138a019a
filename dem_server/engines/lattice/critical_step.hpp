// Largest time step at which central differences stay stable, by a bound that holds for every packing.
//
// The highest frequency of an assembly is at most that of its worst element (Irons): give every bond an equal
// share m / n, J / n of its particles, n being a particle's number of bonds. Alone, a bond has two modes,
//   normal: omega^2 = kn (n1 + n2) / m,     shear: omega^2 = ks ((n1 + n2) / m + R^2 (n1 + n2) / J),
// inside the packing n = 6, and with J = m R^2 / 2: 12 kn / m and 36 ks / m. The step is 2 / omega. Where
// some bonds are stiffer by a factor, a bond's share is in proportion to its stiffness, the larger of kn and
// ks.
//
// Weights cannot shorten it: a bond of weight w has stiffness w k, and because a particle's weight is the
// mean over its n' <= n remaining bonds, by stiffness (weigh.hpp), m sum(w) / n' for equal ones, each of them
// finds a share w m / n' >= w m / n of its own. Nor does breaking, which takes stiffness away and leaves the
// mass.
#pragma once

#include "dem_server/engines/answers.hpp"
#include "dem_server/engines/lattice/assembly.hpp"
#include "dem_server/model/calibration.hpp"

namespace adit::dem {

// The bond with the smallest critical step, of an assembly with at least one.
CriticalElement critical_element(const Assembly& assembly, const BondStiffness& stiffness);
inline double critical_step(const Assembly& assembly, const BondStiffness& stiffness) {
  return critical_element(assembly, stiffness).step;
}

}  // namespace adit::dem
