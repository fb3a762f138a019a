#include "protocol/sections/strength.hpp"

#include <algorithm>
#include <cmath>

namespace adit::sections {

Use use_of(const Strength& strength, const SectionForces& forces, double shear) {
  constexpr double kLeast = 1;  // where thrust takes all of a strength [N], [N m]
  const Bending bending = forces.moment >= 0 ? Bending::kOuterStretched : Bending::kInnerStretched;
  const double resists = shear_capacity(strength.shape, strength.shear, bending, forces.thrust);
  const double ultimate = std::abs(strength.capacity.moment(bending, forces.thrust));
  return {strength.capacity.utilisation(forces), std::abs(forces.moment) / std::max(ultimate, kLeast),
          resists, std::abs(shear) / std::max(resists, kLeast)};
}

std::size_t damage_state(const Strength& strength, double moment_ratio) {
  return static_cast<std::size_t>(
      std::ranges::count_if(strength.damage_states, [&](double from) { return moment_ratio > from; }));
}

}  // namespace adit::sections
