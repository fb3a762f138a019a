// One chunk of pairs on its way through the kernel: what it needs of its discs and laws, what it gives.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/general/pairs/block_discs.hpp"
#include "dem_server/engines/general/pairs/pairs.hpp"

namespace adit::dem {

using ChunkColumn = std::array<double, kChunk>;

// The laws of the pairs, one value each, or the first for all where there is one law: what contact
// bonds need, and the rest where contacts act. `intact` and `contact_acts`, where some bond is broken, are 1
// where the bond and where the contact acts, else 0.
struct ChunkLaws {
  alignas(64) ChunkColumn kn, ks, km, tensile_strength, moment_factor, cohesion, tan_friction_angle;
  ChunkColumn contact_kn, contact_ks, contact_compliance, friction, normal_beta, shear_beta;
  ChunkColumn intact, contact_acts;
};
void look_up_laws(const Pairs::Chunk& chunk, std::span<const PairLaw> laws, const Pairs& pairs,
                  ChunkLaws& out);

// Differences of displacement, velocity, place at rest and spin (second disc less first), sums of the spins,
// and where dashpots act inverse masses and moments of inertia, weighted.
struct ChunkDiscs {
  alignas(64) ChunkColumn ux, uy, vx, vy, rest_x, rest_y, turn_rate, spin_sum;
  ChunkColumn inverse_mass, inverse_inertia_1, inverse_inertia_2;
};
void look_up_discs(const Pairs::Chunk& chunk, const Pairs& pairs, const BlockDiscs& of_block,
                   ChunkDiscs& discs);
void look_up_masses(const Pairs::Chunk& chunk, const Pairs& pairs, const Particles& particles,
                    ChunkDiscs& discs);

// Forces and moments on the first disc, the moment on the second, weighted; N, unweighted; what friction and
// dashpots took, weighted.
struct ChunkForces {
  alignas(64) ChunkColumn x, y, moment_1, moment_2, normal, friction, dashpot;
};
// Adds them to the sums of their discs, in the order of the pairs.
void add_to_discs(const Pairs::Chunk& chunk, const Pairs& pairs, const ChunkForces& forces,
                  BlockDiscs& of_block);

// A block's pairs in one step; sums over blocks are taken in their order.
struct PairResult {
  double max_normal_force = 0;        // largest |N|, unweighted [N]; not finite where any is not
  std::uint32_t strongest = 0;        // the first pair that carries it
  double friction = 0, dashpots = 0;  // dissipated in this step, weighted [J]
  double released = 0;                // stored in the bonds that broke, weighted [J]
  double internal_force = 0;          // sum of |force|, weighted, while it relaxes [N]
  std::vector<std::uint32_t> broken;  // pairs, ascending
};

}  // namespace adit::dem
