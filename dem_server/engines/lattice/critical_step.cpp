#include "dem_server/engines/lattice/critical_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dem_server/packing/meeting_place.hpp"

namespace adit::dem {

CriticalElement critical_element(const Assembly& assembly, const BondStiffness& stiffness) {
  const Particles& p = assembly.particles;
  const Bonds& b = assembly.bonds;
  const double arm = b.rest_length / 2;
  // Sum of the weights of a particle's bonds: bond k's share of the particle is weight(k) / total.
  std::vector<double> total(p.size(), 0.0);
  for (std::size_t k = 0; k < b.size(); ++k)
    for (const std::uint32_t i : {b.first[k], b.second[k]}) total[i] += b.weight[k];

  double largest = 0;  // omega^2
  std::size_t critical = 0;
  for (std::size_t k = 0; k < b.size(); ++k) {
    const std::uint32_t i = b.first[k], j = b.second[k];
    // weight(k) k / (m weight(k) / total): the bond's own weight cancels.
    const double by_mass = total[i] * p.inverse_mass[i] + total[j] * p.inverse_mass[j];
    const double by_inertia = total[i] * p.inverse_inertia[i] + total[j] * p.inverse_inertia[j];
    const double squared =
        std::max(stiffness.normal * by_mass, stiffness.shear * (by_mass + arm * arm * by_inertia));
    if (squared > largest) critical = k;
    largest = std::max(largest, squared);
  }
  const auto [x, y] = meeting_place(p, b.first[critical], b.second[critical]);
  return {2 / std::sqrt(largest), "bond", x, y};
}

}  // namespace adit::dem
