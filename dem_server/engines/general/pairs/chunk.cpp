#include "dem_server/engines/general/pairs/chunk.hpp"

#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

template <bool kDashpots>
ADIT_VECTOR_CLONES void look_up(const Pairs::Chunk& chunk, const Particles& p, const Pairs& pairs,
                                ChunkDiscs& discs) {
  const std::uint32_t *first = &pairs.first[chunk.begin], *second = &pairs.second[chunk.begin];
  const double *ux = p.ux.data(), *uy = p.uy.data(), *vx = p.vx.data(), *vy = p.vy.data(),
               *spin = p.spin.data();
  const double *inverse_mass = p.inverse_mass.data(), *inverse_inertia = p.inverse_inertia.data();
  const double* weight = &pairs.weight[chunk.begin];
  const std::uint32_t count = chunk.end - chunk.begin;
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t i = first[k], j = second[k];
    discs.ux[k] = ux[j] - ux[i];
    discs.uy[k] = uy[j] - uy[i];
    discs.vx[k] = vx[j] - vx[i];
    discs.vy[k] = vy[j] - vy[i];
    discs.spin_1[k] = spin[i];
    discs.spin_2[k] = spin[j];
    if constexpr (kDashpots) {
      discs.inverse_mass[k] = weight[k] * (inverse_mass[i] + inverse_mass[j]);
      discs.inverse_inertia_1[k] = weight[k] * inverse_inertia[i];
      discs.inverse_inertia_2[k] = weight[k] * inverse_inertia[j];
    }
  }
}

}  // namespace

void look_up_discs(const Pairs::Chunk& chunk, bool dashpots, const Particles& particles, const Pairs& pairs,
                   ChunkDiscs& discs) {
  dashpots ? look_up<true>(chunk, particles, pairs, discs) : look_up<false>(chunk, particles, pairs, discs);
}

void look_up_laws(const Pairs::Chunk& chunk, bool dashpots, std::span<const PairLaw> laws, const Pairs& pairs,
                  ChunkLaws& out) {
  const std::uint32_t count = chunk.end - chunk.begin;
  for (std::uint32_t k = 0; k < (chunk.one_law ? 1 : count); ++k) {
    const PairLaw& law = laws[pairs.law[chunk.begin + k]];
    out.kn[k] = law.kn;
    out.ks[k] = law.ks;
    out.km[k] = law.km;
    out.tensile_strength[k] = law.tensile_strength;
    out.moment_factor[k] = law.moment_factor;
    out.cohesion[k] = law.cohesion;
    out.tan_friction_angle[k] = law.tan_friction_angle;
    out.contact_kn[k] = law.contact.normal_stiffness;
    out.contact_ks[k] = law.contact.shear_stiffness;
    out.contact_compliance[k] = law.contact.shear_stiffness > 0 ? 1 / law.contact.shear_stiffness : 0;
    out.friction[k] = law.contact.friction;
    out.normal_beta[k] = law.contact.normal_damping;
    out.shear_beta[k] = law.contact.shear_damping;
  }
  if (!pairs.bonded() || (chunk.kind != Pairs::Kind::kGeneral && !dashpots)) return;
  for (std::uint32_t k = 0; k < count; ++k) {
    const bool intact = pairs.state[chunk.begin + k] == BondState::kIntact;
    out.intact[k] = intact ? 1 : 0;
    out.contact_acts[k] = !intact || laws[pairs.law[chunk.begin + k]].contact_beside_bond ? 1 : 0;
  }
}

}  // namespace adit::dem
