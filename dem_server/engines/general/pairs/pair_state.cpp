#include "dem_server/engines/general/pairs/pair_state.hpp"

#include "dem_server/engines/general/pairs/chunk.hpp"
#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/laws/spring.hpp"
#include "protocol/kernels/sums.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

// Stored in each pair of a chunk, weighted [J].
struct ChunkStored {
  alignas(64) ChunkColumn bond, contact;
};

// The loop over a chunk whose bonds are intact, or that has none. It becomes vector code.
template <bool kBonds, bool kContacts, bool kOneLaw>
ADIT_VECTOR_CLONES void find_stored(const Pairs::Chunk& chunk, const ChunkDiscs& discs, const ChunkLaws& laws,
                                    const Pairs& pairs, ChunkStored& out) {
  const std::uint32_t begin = chunk.begin, count = chunk.end - chunk.begin;
  const double *rest_length = &pairs.rest_length[begin], *weight = &pairs.weight[begin],
               *slack = &pairs.slack[begin], *slide = &pairs.slide[begin];
  const double *width = kBonds ? &pairs.width[begin] : nullptr,
               *initial = kBonds ? &pairs.initial[begin] : nullptr,
               *shear = kBonds ? &pairs.shear[begin] : nullptr,
               *moment = kBonds ? &pairs.moment[begin] : nullptr;
  const auto of_pair = [](const ChunkColumn& column, std::uint32_t k) { return column[kOneLaw ? 0 : k]; };
#pragma GCC ivdep
  for (std::uint32_t k = 0; k < count; ++k) {
    const PairShape s = kBonds ? bond_shape<Division::kShared>(discs.rest_x[k], discs.rest_y[k],
                                                               rest_length[k], discs.ux[k], discs.uy[k])
                               : contact_shape<Division::kShared>(discs.rest_x[k], discs.rest_y[k],
                                                                  rest_length[k], discs.ux[k], discs.uy[k]);
    if constexpr (kBonds) {
      const BondSprings springs = springs_of_width(of_pair(laws.kn, k), of_pair(laws.ks, k),
                                                   kContacts ? of_pair(laws.km, k) : 0.0, width[k]);
      const double normal = bond_normal_force(springs.kn, s.elongation) + initial[k];
      out.bond[k] = weight[k] * (spring_energy(normal, springs.kn) + spring_energy(shear[k], springs.ks) +
                                 (kContacts ? spring_energy(moment[k], springs.km) : 0.0));
    }
    if constexpr (kContacts) {
      const double kn = of_pair(laws.contact_kn, k), ks = of_pair(laws.contact_ks, k);
      const double normal = contact_normal_force(kn, s.elongation + slack[k]);
      out.contact[k] = weight[k] * (spring_energy(normal, kn) + spring_energy(slide[k], ks));
    }
  }
}

template <bool kBonds, bool kContacts>
void find_stored_of(const Pairs::Chunk& chunk, const ChunkDiscs& discs, const ChunkLaws& laws,
                    const Pairs& pairs, ChunkStored& out) {
  const auto find =
      chunk.one_law ? find_stored<kBonds, kContacts, true> : find_stored<kBonds, kContacts, false>;
  find(chunk, discs, laws, pairs, out);
}

// Pair by pair, for chunks in which bonds are broken, or some have contacts beside them.
void add_each(const Pairs::Chunk& chunk, std::span<const PairLaw> laws, const Particles& p,
              const Pairs& pairs, Stored& stored) {
  for (std::uint32_t k = chunk.begin; k < chunk.end; ++k) {
    const PairLaw& law = laws[pairs.law[k]];
    const PairState s = state_of(k, laws, p, pairs);
    const BondSprings springs = springs_of(law, pairs, k);
    (law.contact_beside_bond ? stored.parallel_bonds : stored.contact_bonds) +=
        pairs.weight[k] *
        (spring_energy(s.bond_normal, springs.kn) + spring_energy(s.shear - pairs.slide[k], springs.ks) +
         spring_energy(s.moment, springs.km));
    stored.contacts += pairs.weight[k] * (spring_energy(s.contact_normal, law.contact.normal_stiffness) +
                                          spring_energy(pairs.slide[k], law.contact.shear_stiffness));
  }
}

}  // namespace

BondSprings springs_of(const PairLaw& law, const Pairs& pairs, std::uint32_t pair) {
  if (!pairs.bonded()) return {0, 0, 0};
  return springs_of_width(law.kn, law.ks, law.km, pairs.width[pair]);
}

PairShape shape_of(const Pairs& pairs, std::uint32_t k, double ux, double uy) {
  const auto shape = pairs.bonded() ? bond_shape<Division::kEach> : contact_shape<Division::kEach>;
  return shape(pairs.rest_x[k], pairs.rest_y[k], pairs.rest_length[k], ux, uy);
}

PairState state_of(std::uint32_t pair, std::span<const PairLaw> laws, const Particles& p,
                   const Pairs& pairs) {
  const PairLaw& law = laws[pairs.law[pair]];
  const std::uint32_t i = pairs.first[pair], j = pairs.second[pair];
  const PairShape s = shape_of(pairs, pair, p.ux[j] - p.ux[i], p.uy[j] - p.uy[i]);
  const bool intact = pairs.bonded() && pairs.state[pair] == BondState::kIntact;
  const double bond =
      intact ? bond_normal_force(springs_of(law, pairs, pair).kn, s.elongation) + pairs.initial[pair] : 0;
  const double gap = intact && !law.contact_beside_bond ? 0 : s.elongation + pairs.slack[pair];
  return {s.nx,
          s.ny,
          s.length,
          bond,
          contact_normal_force(law.contact.normal_stiffness, gap),
          (intact ? pairs.shear[pair] : 0) + pairs.slide[pair],
          intact ? pairs.moment[pair] : 0,
          gap < 0};
}

void add_stored(std::uint32_t block, std::span<const PairLaw> laws, const Particles& particles,
                const Pairs& pairs, BlockDiscs& of_block, Stored& stored) {
  if (pairs.chunk_starts[block] == pairs.chunk_starts[block + 1]) return;
  ChunkDiscs discs;
  ChunkLaws of_chunk;
  ChunkStored found;
  of_block.take_reached(block, pairs, particles);
  for (std::uint32_t c = pairs.chunk_starts[block]; c < pairs.chunk_starts[block + 1]; ++c) {
    const Pairs::Chunk& chunk = pairs.chunks[c];
    const bool bonded = pairs.bonded(), contacts = chunk.contacts_act();
    if (bonded && chunk.kind == Pairs::Kind::kGeneral) {
      add_each(chunk, laws, particles, pairs, stored);
      continue;
    }
    look_up_discs(chunk, pairs, of_block, discs);
    look_up_laws(chunk, laws, pairs, of_chunk);
    const auto find = !bonded    ? find_stored_of<false, true>
                      : contacts ? find_stored_of<true, true>
                                 : find_stored_of<true, false>;
    find(chunk, discs, of_chunk, pairs, found);
    const std::uint32_t count = chunk.end - chunk.begin;
    if (bonded)
      (contacts ? stored.parallel_bonds : stored.contact_bonds) +=
          protocol::sum_of(std::span(found.bond).first(count));
    if (contacts) stored.contacts += protocol::sum_of(std::span(found.contact).first(count));
  }
}

}  // namespace adit::dem
