#include "dem_server/engines/general/pairs/pair_forces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "dem_server/engines/general/pairs/bond_breaking.hpp"
#include "dem_server/engines/general/pairs/pair_kernel.hpp"
#include "protocol/kernels/prefetch.hpp"
#include "protocol/kernels/sums.hpp"

namespace adit::dem {
namespace {

constexpr std::size_t kCached = 1 << 14;  // discs: memory is asked for beforehand in larger models

std::int64_t bits_of_size(double force) {
  return std::bit_cast<std::int64_t>(std::abs(force));
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

// What the kernel reads of a chunk.
[[gnu::always_inline]] inline void prefetch(const Pairs::Chunk& chunk, const Pairs& pairs) {
  using Kind = Pairs::Kind;
  const protocol::IndexRange range{chunk.begin, chunk.end};
  const std::span<const protocol::IndexRange> all(&range, 1);
  const bool bonded = pairs.bonded(), contacts = chunk.contacts_act();
  protocol::prefetch(all, {pairs.rest_length.data(), pairs.half_difference.data()});
  if (bonded) protocol::prefetch(all, {pairs.shear.data()});
  if (contacts) protocol::prefetch(all, {pairs.slide.data()});
  if (bonded && contacts) protocol::prefetch(all, {pairs.moment.data()});
  if (chunk.kind == Kind::kIntact || chunk.kind == Kind::kGeneral)
    protocol::prefetch(all, {pairs.weight.data(), pairs.slack.data()});
}

}  // namespace

void add_pair_forces(std::uint32_t block, std::span<const PairLaw> laws, double dt, bool relax,
                     const Particles& particles, Pairs& pairs, BlockDiscs& of_block, PairResult& result) {
  result.max_normal_force = result.friction = result.dashpots = result.released = result.internal_force = 0;
  result.broken.clear();
  if (!pairs.in_block(block)) return;
  ChunkDiscs discs;
  ChunkLaws of_chunk;
  ChunkForces forces;
  std::int64_t max_bits = 0;
  const bool ahead = particles.size() > kCached;
  of_block.take_reached(block, pairs, particles);
  for (std::uint32_t c = pairs.chunk_starts[block]; c < pairs.chunk_starts[block + 1]; ++c) {
    Pairs::Chunk& chunk = pairs.chunks[c];
    const std::uint32_t count = chunk.end - chunk.begin;
    if (ahead && c + 1 < pairs.chunk_starts[block + 1]) prefetch(pairs.chunks[c + 1], pairs);
    const bool dashpots = !pairs.normal_dashpot.empty() && chunk.contacts_act();
    look_up_discs(chunk, pairs, of_block, discs);
    if (dashpots) look_up_masses(chunk, pairs, particles, discs);
    look_up_laws(chunk, laws, pairs, of_chunk);
    ChunkOutcome outcome = find_forces(chunk, dt, discs, of_chunk, dashpots, pairs, forces);
    if (outcome.breaks) outcome.max_bits = break_bonds(chunk, laws, dt, discs, pairs, forces, result);
    const auto filled = [count](const ChunkColumn& column) { return std::span(column).first(count); };
    if (outcome.slides) result.friction += protocol::sum_of(filled(forces.friction));
    if (dashpots) result.dashpots += protocol::sum_of(filled(forces.dashpot));
    if (relax) result.internal_force += protocol::sum_of_sizes(filled(forces.x), filled(forces.y));
    add_to_discs(chunk, pairs, forces, of_block);
    if (outcome.max_bits > max_bits) {
      max_bits = outcome.max_bits;
      std::uint32_t k = 0;
      while (bits_of_size(forces.normal[k]) != max_bits) ++k;
      result.strongest = chunk.begin + k;
    }
  }
  of_block.give_reached(block, pairs);
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
