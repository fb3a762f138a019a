#include "dem_server/engines/general/pairs/pair_forces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "dem_server/engines/general/pairs/bond_breaking.hpp"
#include "dem_server/engines/general/pairs/chunk.hpp"
#include "dem_server/engines/general/pairs/pair_kernel.hpp"

namespace adit::dem {
namespace {

std::int64_t bits_of_size(double force) {
  return std::bit_cast<std::int64_t>(std::abs(force));
}

// Adds to discs before `end`; what acts on others goes to `away`, from `slot` on.
void apply(const Pairs::Chunk& chunk, std::uint32_t end, const ChunkForces& forces, Particles& p,
           Pairs& pairs, std::uint32_t& slot) {
  double *fx = p.fx.data(), *fy = p.fy.data(), *moment = p.moment.data();
  const std::uint32_t *first = &pairs.first[chunk.begin], *second = &pairs.second[chunk.begin];
  const std::uint32_t count = chunk.end - chunk.begin;
  for (std::uint32_t k = 0; k < count;) {
    const std::uint32_t i = first[k];
    double x = fx[i], y = fy[i], m = moment[i];
    for (; k < count && first[k] == i; ++k) {
      x += forces.x[k];
      y += forces.y[k];
      m += forces.moment_1[k];
      const std::uint32_t j = second[k];
      if (j < end) {
        fx[j] -= forces.x[k];
        fy[j] -= forces.y[k];
        moment[j] += forces.moment_2[k];
      } else {
        pairs.away_x[slot] = forces.x[k];
        pairs.away_y[slot] = forces.y[k];
        pairs.away_moment[slot] = forces.moment_2[k];
        ++slot;
      }
    }
    fx[i] = x;
    fy[i] = y;
    moment[i] = m;
  }
}

// Breaks the chunk's bonds that exceed a strength. Returns the bits of the largest |N| that is left.
std::int64_t break_bonds(Pairs::Chunk& chunk, std::span<const PairLaw> laws, double dt,
                         const ChunkDiscs& discs, Pairs& pairs, ChunkForces& forces, PairResult& result) {
  chunk.kind = Pairs::Kind::kGeneral;
  std::int64_t max_bits = 0;
  for (std::uint32_t pair = chunk.begin, k = 0; pair < chunk.end; ++pair, ++k) {
    if (break_bond(laws[pairs.law[pair]], pair, k, dt, discs, pairs, forces, result.released))
      result.broken.push_back(pair);
    max_bits = std::max(max_bits, bits_of_size(forces.normal[k]));
  }
  return max_bits;
}

}  // namespace

void add_pair_forces(std::uint32_t block, std::span<const PairLaw> laws, double dt, Particles& particles,
                     Pairs& pairs, PairResult& result) {
  ChunkDiscs discs;
  ChunkLaws of_chunk;
  ChunkForces forces;
  const bool dashpots = !pairs.normal_dashpot.empty();
  const std::uint32_t end = (block + 1) * kBlock;
  std::uint32_t slot = pairs.away_starts[block];
  std::int64_t max_bits = 0;
  result.friction = result.dashpots = result.released = 0;
  result.broken.clear();
  for (std::uint32_t c = pairs.chunk_starts[block]; c < pairs.chunk_starts[block + 1]; ++c) {
    Pairs::Chunk& chunk = pairs.chunks[c];
    const std::uint32_t count = chunk.end - chunk.begin;
    look_up_discs(chunk, dashpots, particles, pairs, discs);
    look_up_laws(chunk, dashpots, laws, pairs, of_chunk);
    const bool contact_beside_bond = laws[pairs.law[chunk.begin]].contact_beside_bond;
    ChunkOutcome outcome =
        find_forces(chunk, dt, discs, of_chunk, contact_beside_bond, dashpots, pairs, forces);
    if (outcome.breaks) outcome.max_bits = break_bonds(chunk, laws, dt, discs, pairs, forces, result);
    if (outcome.slides)
      for (std::uint32_t k = 0; k < count; ++k) result.friction += forces.friction[k];
    if (dashpots)
      for (std::uint32_t k = 0; k < count; ++k) result.dashpots += forces.dashpot[k];
    apply(chunk, end, forces, particles, pairs, slot);
    if (outcome.max_bits > max_bits) {
      max_bits = outcome.max_bits;
      std::uint32_t k = 0;
      while (bits_of_size(forces.normal[k]) != max_bits) ++k;
      result.strongest = chunk.begin + k;
    }
  }
  result.max_normal_force = std::bit_cast<double>(max_bits);
}

void gather_pair_forces(std::uint32_t block, const Pairs& pairs, Particles& p) {
  for (std::uint32_t k = pairs.arrival_starts[block]; k < pairs.arrival_starts[block + 1]; ++k) {
    const auto [slot, disc] = pairs.arrivals[k];
    p.fx[disc] -= pairs.away_x[slot];
    p.fy[disc] -= pairs.away_y[slot];
    p.moment[disc] += pairs.away_moment[slot];
  }
}

}  // namespace adit::dem
