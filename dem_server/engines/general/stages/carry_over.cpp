#include "dem_server/engines/general/stages/carry_over.hpp"

#include <algorithm>
#include <utility>

#include "dem_server/engines/general/pairs/pair_state.hpp"

namespace adit::dem {
namespace {

using Ends = std::pair<std::uint32_t, std::uint32_t>;

void start_free(const PairLaw& law, const Particles& p, std::uint32_t k, Pairs& bonds) {
  const std::uint32_t i = bonds.first[k], j = bonds.second[k];
  const PairShape now = shape_of(bonds, k, p.ux[j] - p.ux[i], p.uy[j] - p.uy[i]);
  bonds.initial[k] = -bond_normal_force(law.kn * bonds.width[k], now.elongation);
  bonds.slack[k] = std::max(0.0, now.length - p.radius[i] - p.radius[j]) - now.elongation;
}

void take_state(const Pairs& from, std::uint32_t old, std::uint32_t k, Pairs& to) {
  to.slack[k] = from.slack[old];
  to.slide[k] = from.slide[old];
  to.initial[k] = from.initial[old];
  to.shear[k] = from.shear[old];
  to.moment[k] = from.moment[old];
  to.state[k] = from.state[old];
  if (to.normal_dashpot.empty() || from.normal_dashpot.empty()) return;
  to.normal_dashpot[k] = from.normal_dashpot[old];
  to.shear_dashpot[k] = from.shear_dashpot[old];
}

}  // namespace

void carry_over(const StagePairs& before, const std::vector<bool>& fresh, std::span<const PairLaw> laws,
                const Particles& particles, Pairs& bonds) {
  const Pairs& from = before.bonds;
  for (std::uint32_t k = 0, old = 0; k < bonds.size(); ++k) {
    const Ends ends{bonds.first[k], bonds.second[k]};
    while (old < from.size() && Ends{from.first[old], from.second[old]} < ends) ++old;
    const bool same = old < from.size() && Ends{from.first[old], from.second[old]} == ends &&
                      before.laws[from.law[old]] == laws[bonds.law[k]] && from.width[old] == bonds.width[k];
    if (same && !fresh[ends.first] && !fresh[ends.second])
      take_state(from, old, k, bonds);
    else
      start_free(laws[bonds.law[k]], particles, k, bonds);
  }
  bonds.sort_chunks(laws);
}

void carry_over(std::span<const Joints::Joint> before, const std::vector<bool>& fresh,
                std::vector<Joints::Joint>& joints) {
  auto old = before.begin();
  for (Joints::Joint& joint : joints) {
    const Ends ends{joint.first, joint.second};
    while (old != before.end() && Ends{old->first, old->second} < ends) ++old;
    if (old != before.end() && Ends{old->first, old->second} == ends && old->law == joint.law &&
        old->nx == joint.nx && old->ny == joint.ny && !fresh[joint.first] && !fresh[joint.second])
      joint = *old;
  }
}

}  // namespace adit::dem
