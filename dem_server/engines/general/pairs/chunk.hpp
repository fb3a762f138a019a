// One chunk of pairs on its way through the kernel: what it needs of its discs and laws, what it gives.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "dem_server/engines/general/pairs/pairs.hpp"
#include "dem_server/particles/particles.hpp"

namespace adit::dem {

using ChunkColumn = std::array<double, kChunk>;

// Differences of displacement and velocity (second disc less first), spins, and where dashpots act inverse
// masses and moments of inertia, weighted.
struct ChunkDiscs {
  alignas(64) ChunkColumn ux, uy, vx, vy, spin_1, spin_2, inverse_mass, inverse_inertia_1, inverse_inertia_2;
};

// The laws of the pairs, one value each, or the first for all where there is one law. `intact` and
// `contact_acts`, of each pair, are 1 where the bond and where the contact acts, else 0.
struct ChunkLaws {
  alignas(64) ChunkColumn kn, ks, km, tensile_strength, moment_factor, cohesion, tan_friction_angle;
  ChunkColumn contact_kn, contact_ks, contact_compliance, friction, normal_beta, shear_beta;
  ChunkColumn intact, contact_acts;
};

// Forces and moments on the first disc, the moment on the second, weighted; N, unweighted; what friction and
// dashpots took, weighted.
struct ChunkForces {
  alignas(64) ChunkColumn x, y, moment_1, moment_2, normal, friction, dashpot;
};

void look_up_discs(const Pairs::Chunk& chunk, bool dashpots, const Particles& particles, const Pairs& pairs,
                   ChunkDiscs& discs);
void look_up_laws(const Pairs::Chunk& chunk, bool dashpots, std::span<const PairLaw> laws, const Pairs& pairs,
                  ChunkLaws& out);

}  // namespace adit::dem
