#include "dem_server/engines/general/pairs/pair_state.hpp"

#include "dem_server/laws/linear_contact.hpp"

namespace adit::dem {

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

}  // namespace adit::dem
