// Central differences: displacements at n from velocities at n - 1/2, velocities at n + 1/2 from forces at n.
// Each for some of the particles.
#pragma once

#include <span>

#include "dem_server/particles/particles.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::dem {

// u += dt v. Returns the largest v^2 [m^2/s^2].
double move(double dt, std::span<const protocol::IndexRange> some, Particles& particles);

// v += dt (f / m + gravity) and spin += dt moment / J; half of dt in a step from rest. Statics may damp
// forces and moment (protocol/participant/local_damping.hpp).
void kick(const protocol::Step& step, std::span<const protocol::IndexRange> some,
          const Resultants& resultants, Particles& particles, const Acceleration& gravity = {});

}  // namespace adit::dem
