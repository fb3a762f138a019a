// The solid slab in plan that stands for a hollow section, alone or with joints spread over its length.
//
// Models in plan compute per metre of thickness. A slab of the width w and the modulus E* has E* w along its
// axis and E* w^3/12 in bending, so that
//   w = sqrt(12 I/A),   E* = E A/w,   rho* = mass/w
// have the section's EA, its EI in the horizontal plane, and its mass and rotary inertia per metre. All
// forces are then those of the whole section. The shear stiffness, 5/6 G* w, is that of the area 5/6 A and
// differs from the section's.
//
// Joints spread over a length L add their flexibility at rest: L/EA' = L/EA + sum 1/k, likewise in bending
// and in shear. These three are matched by the moduli of the inner half of the width and of the quarters on
// either side, E_i + E_o = 2 EA'/w and E_i + 7 E_o = 96 EI'/w^3, and by Poisson's ratio, which in a beam only
// tells G* from E*.
#pragma once

#include <span>

#include "protocol/messages/scene.pb.h"
#include "simplified/beam/model/tunnel.hpp"

namespace adit::simplified {

struct Slab {
  double width;          // [m]
  double young_modulus;  // E* [Pa]
  double poisson_ratio;
  double density;  // rho* [kg/m^3]
};

Slab slab_of(const scene::Section& section);

struct JointedSlab {
  double inner_modulus, outer_modulus;  // of the inner half of the width, and outside of it [Pa]
  double poisson_ratio;                 // within -0.5 and 0.3, as near as it comes to the shear stiffness
};

// The slab with these joints over a length [m]. What a joint does not hold at rest, such as keys within their
// clearance, is left out.
JointedSlab spread(const scene::Section& section, const Slab& slab, std::span<const beam::Joint> joints,
                   double length);

}  // namespace adit::simplified
