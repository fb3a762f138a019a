// What of a model carries forces at rest, as springs of reference: bonds, and discs that touch without one.
//
// At the place where two discs meet their material moves apart by
//   r = (u2 - u1) - (arm_1 w1 + arm_2 w2) t,    t the left normal of the line of centres,
// u and w being their displacements and rotations. A link resists it along its own axes, those of the line
// of centres or of a smooth joint's plane, and a strip of cement resists that one disc turns against the
// other: N = kn r.n, S = ks r.t, M = km (w2 - w1). All links have kn = 1 and one ratio ks / kn, the mean of
// the model's: forces that carry a stress are no matter of stiffness, and contrasts between groups would only
// disturb a uniform one. But a link that does not resist slip bears no shear force: where an excavation took
// away what balanced it, it would spin its discs without end.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {

struct Link {
  std::uint32_t first, second;
  double x, y;          // from the first to the second centre [m]
  double at_x, at_y;    // its middle [m]
  double ex, ey;        // the direction of (x, y)
  double arm_1, arm_2;  // from the centres to where the discs meet [m]
  double nx, ny;        // along which N acts
  double kn, ks, km;    // of reference; km [m^2]
};

// Uniform and symmetric; xy is the tensor's, half of gamma.
struct Strain {
  double xx, yy, xy;
};

// The links of the model's bonds, in their order, then of the pairs that touch.
std::vector<Link> links_of(const Model& model, std::span<const Pair> touching);

// Forces where the discs follow the strain and do not turn.
PairForces forces_under(const Strain& strain, const Link& link);

// How N, S and M grow with the motions x, y, w of the first and of the second disc, per unit stiffness.
using Stretching = std::array<std::array<double, 6>, 3>;
Stretching stretching(const Link& link);

// On the first disc.
inline PlaneVector force_on_first(const Link& link, const PairForces& forces) {
  return vector_of(link.nx, link.ny, forces.normal, forces.shear);
}

}  // namespace adit::dem
