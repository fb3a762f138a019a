#include "dem_server/engines/general/pairs/chunk.hpp"

#include <algorithm>
#include <limits>

#include "dem_server/engines/general/pairs/lanes.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

using Places = std::array<std::uint32_t, kLanes>;

// The places of eight pairs; the last ones of a block may be fewer, and any disc stands for the others.
[[gnu::always_inline]] inline Places places_at(const std::vector<std::uint32_t>& places, std::uint32_t begin,
                                               std::uint32_t end) {
  Places at{};
  if (begin + kLanes <= end)
    std::copy_n(&places[begin], kLanes, at.begin());
  else
    std::copy_n(&places[begin], end - begin, at.begin());
  return at;
}

}  // namespace

ADIT_VECTOR_CLONES void look_up_discs(const Pairs::Chunk& chunk, const Pairs& pairs,
                                      const BlockDiscs& of_block, ChunkDiscs& discs) {
  using Bits [[gnu::vector_size(64)]] = std::int64_t;
  constexpr Bits kSignOfLast{0, 0, 0, 0, 0, 0, 0, std::numeric_limits<std::int64_t>::min()};
  const double* motions = of_block.motions();
  for (std::uint32_t at = chunk.begin, k = 0; at < chunk.end; at += kLanes, k += kLanes) {
    const Places first = places_at(pairs.first_place, at, chunk.end),
                 second = places_at(pairs.second_place, at, chunk.end);
    Eight columns[kLanes];
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
      Eight a, b;
      load(motions + first[lane], a);
      load(motions + second[lane], b);
      columns[lane] = b - (Eight)((Bits)a ^ kSignOfLast);
    }
    turn(columns);
    store(columns[0], &discs.ux[k]);
    store(columns[1], &discs.uy[k]);
    store(columns[2], &discs.vx[k]);
    store(columns[3], &discs.vy[k]);
    store(columns[4], &discs.rest_x[k]);
    store(columns[5], &discs.rest_y[k]);
    store(columns[6], &discs.turn_rate[k]);
    store(columns[7], &discs.spin_sum[k]);
  }
}

void look_up_masses(const Pairs::Chunk& chunk, const Pairs& pairs, const Particles& p, ChunkDiscs& discs) {
  for (std::uint32_t pair = chunk.begin, k = 0; pair < chunk.end; ++pair, ++k) {
    const std::uint32_t i = pairs.first[pair], j = pairs.second[pair];
    const double weight = pairs.weight[pair];
    discs.inverse_mass[k] = weight * (p.inverse_mass[i] + p.inverse_mass[j]);
    discs.inverse_inertia_1[k] = weight * p.inverse_inertia[i];
    discs.inverse_inertia_2[k] = weight * p.inverse_inertia[j];
  }
}

ADIT_VECTOR_CLONES void add_to_discs(const Pairs::Chunk& chunk, const Pairs& pairs, const ChunkForces& forces,
                                     BlockDiscs& of_block) {
  add_to_sums<1>(chunk.end - chunk.begin, &pairs.first_place[chunk.begin], &pairs.second_place[chunk.begin],
                 forces.x.data(), forces.y.data(), forces.moment_1.data(), forces.moment_2.data(),
                 of_block.sums());
}

void look_up_laws(const Pairs::Chunk& chunk, std::span<const PairLaw> laws, const Pairs& pairs,
                  ChunkLaws& out) {
  const std::uint32_t count = chunk.end - chunk.begin, different = chunk.one_law ? 1 : count;
  const auto law_of = [&](std::uint32_t k) -> const PairLaw& {
    return laws[k == 0 ? chunk.law : pairs.law[chunk.begin + k]];
  };
  for (std::uint32_t k = 0; pairs.bonded() && k < different; ++k) {
    const PairLaw& law = law_of(k);
    out.kn[k] = law.kn;
    out.ks[k] = law.ks;
    out.tensile_strength[k] = law.tensile_strength;
    out.cohesion[k] = law.cohesion;
  }
  if (!chunk.contacts_act()) return;
  for (std::uint32_t k = 0; k < different; ++k) {
    const PairLaw& law = law_of(k);
    out.km[k] = law.km;
    out.moment_factor[k] = law.moment_factor;
    out.tan_friction_angle[k] = law.tan_friction_angle;
    const LinearContact& contact = law.contact;
    out.contact_kn[k] = contact.normal_stiffness;
    out.contact_ks[k] = contact.shear_stiffness;
    out.contact_compliance[k] = contact.shear_stiffness > 0 ? 1 / contact.shear_stiffness : 0;
    out.friction[k] = contact.friction;
    out.normal_beta[k] = contact.normal_damping;
    out.shear_beta[k] = contact.shear_damping;
  }
  if (!pairs.bonded() || chunk.kind != Pairs::Kind::kGeneral) return;
  for (std::uint32_t k = 0; k < count; ++k) {
    const bool intact = pairs.state[chunk.begin + k] == BondState::kIntact;
    out.intact[k] = intact ? 1 : 0;
    out.contact_acts[k] = !intact || law_of(k).contact_beside_bond ? 1 : 0;
  }
}

}  // namespace adit::dem
