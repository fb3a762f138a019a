// Local damping of statics (Cundall 1987, in Brown: Analytical and computational methods in engineering rock
// mechanics), the same for grid points, particles, their spins and the rotations of beams.
//
// Each component of the motion gets the force D = −a |F| sign(v), F being its unbalanced force and v =
// v(n−½): what oscillates loses a fixed share of its energy in each cycle, whatever its frequency and its
// mass, and what is in equilibrium is not touched.
//
// Tied points: at rest, the own forces f of a point at an interface are not 0: the multipliers' force L
// balances them. F is f + L, else a tied point at rest would be damped by its own internal force. L of step n
// is known only after the velocities of n + ½ were predicted, D included. The impulse of the step before,
// over its kick, stands for it: F(n) = f(n) + L(n−1). At rest both are equal, and D is 0. The delay does not
// destabilize: multipliers answer a change of D by P D, P a projection in the metric of the masses (smaller
// still in the lumped and the split solve), so that an error of L returns after a step as at most a times
// itself, a < 1.
//
// Step: D is a factor 1 ± a of F. Where it is always 1 + a, the scheme is that of masses m / (1 + a), stable
// up to the critical step over √(1 + a); longer steps make the fastest motions grow, which always brake.
#pragma once

#include <cmath>

namespace adit::protocol {

inline double sign(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

// The force after damping [N]. `tie`: of the multipliers at the last step; 0 where nothing is tied.
inline double damped(double force, double tie, double velocity, double share) {
  return force - share * std::abs(force + tie) * sign(velocity);
}

// The change of velocity in a step without damping, from that with it: m / kick times it is the unbalanced
// force. The velocity is that before the step. At tied points this is exact at rest only.
inline double undamped_change(double change, double velocity, double share) {
  return share == 0 ? change : change / (1 - share * sign(change * velocity));
}

}  // namespace adit::protocol
