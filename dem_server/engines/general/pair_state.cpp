#include "dem_server/engines/general/pair_state.hpp"

#include <algorithm>
#include <cmath>

namespace adit::dem {

Cement cement_of(const PairLaw& law, const Pairs& pairs, std::uint32_t pair) {
  if (!pairs.cemented()) return {0, 0, 0};
  const double width = pairs.width[pair];
  return {law.kn * width, law.ks * width, law.km * (width * width * width)};
}

PairShape shape_of(const Pairs& pairs, std::uint32_t k, double ux, double uy) {
  const double dx = pairs.rest_x[k] + ux, dy = pairs.rest_y[k] + uy, length = std::sqrt(dx * dx + dy * dy);
  const double elongation = pairs.cemented() ? (ux * (pairs.rest_x[k] + dx) + uy * (pairs.rest_y[k] + dy)) /
                                                   (length + pairs.rest_length[k])
                                             : length - pairs.rest_length[k];
  return {dx / length,
          dy / length,
          length,
          elongation,
          0.5 * length + pairs.half_difference[k],
          0.5 * length - pairs.half_difference[k]};
}

PairState state_of(std::uint32_t pair, std::span<const PairLaw> laws, const Particles& p,
                   const Pairs& pairs) {
  const PairLaw& law = laws[pairs.law[pair]];
  const std::uint32_t i = pairs.first[pair], j = pairs.second[pair];
  const PairShape s = shape_of(pairs, pair, p.ux[j] - p.ux[i], p.uy[j] - p.uy[i]);
  const bool whole = pairs.cemented() && pairs.state[pair] == BondState::kIntact;
  const double cement = whole ? cement_of(law, pairs, pair).kn * s.elongation + pairs.initial[pair] : 0;
  const double overlap = whole && !law.beside ? 0 : std::min(s.elongation + pairs.slack[pair], 0.0);
  return {s.nx,
          s.ny,
          s.length,
          cement,
          law.contact.normal_stiffness * overlap,
          (whole ? pairs.shear[pair] : 0) + pairs.slide[pair],
          whole ? pairs.moment[pair] : 0,
          overlap < 0};
}

void add_stored(std::span<const PairLaw> laws, const Particles& p, const Pairs& pairs, Stored& stored) {
  const auto in_spring = [](double force, double stiffness) {
    return stiffness > 0 ? 0.5 * force * force / stiffness : 0.0;
  };
  for (std::uint32_t k = 0; k < pairs.size(); ++k) {
    const PairLaw& law = laws[pairs.law[k]];
    const PairState s = state_of(k, laws, p, pairs);
    const auto [kn, ks, km] = cement_of(law, pairs, k);
    (law.beside ? stored.parallel_bonds : stored.contact_bonds) +=
        pairs.weight[k] *
        (in_spring(s.cement_normal, kn) + in_spring(s.shear - pairs.slide[k], ks) + in_spring(s.moment, km));
    stored.contacts += pairs.weight[k] * (in_spring(s.contact_normal, law.contact.normal_stiffness) +
                                          in_spring(pairs.slide[k], law.contact.shear_stiffness));
  }
}

}  // namespace adit::dem
