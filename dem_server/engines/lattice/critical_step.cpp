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
  const double arm = b.rest_length / 2, kn = stiffness.normal, ks = stiffness.shear;
  // The stiffness of a run's bonds over that of a bond without factors.
  const auto relative = [&](const Run& run) {
    return std::max(kn * run.factors.stiffness, ks) / std::max(kn, ks);
  };
  // Bond k's share of a particle is relative(k) weight(k) / total.
  std::vector<double> total(p.size(), 0.0);
  for (const Run& run : b.runs)
    for (std::uint32_t k = run.begin; k < run.begin + run.count; ++k)
      for (const std::uint32_t i : {b.first[k], b.second[k]}) total[i] += relative(run) * b.weight[k];

  double largest = 0;  // omega^2
  std::uint32_t critical = 0;
  for (const Run& run : b.runs)
    for (std::uint32_t k = run.begin; k < run.begin + run.count; ++k) {
      const std::uint32_t i = b.first[k], j = b.second[k];
      // weight(k) k / (m weight(k) relative(k) / total): the bond's own weight cancels.
      const double by_mass = total[i] * p.inverse_mass[i] + total[j] * p.inverse_mass[j];
      const double by_inertia = total[i] * p.inverse_inertia[i] + total[j] * p.inverse_inertia[j];
      const double normal = kn * run.factors.stiffness * by_mass;
      const double shear = ks * (by_mass + arm * arm * by_inertia);
      const double squared = std::max(normal, shear) / relative(run);
      if (squared > largest) critical = k;
      largest = std::max(largest, squared);
    }
  const auto [x, y] = meeting_place(p, b.first[critical], b.second[critical]);
  const double step = 2 / std::sqrt(largest);
  return {step, step, "bond", x, y};
}

}  // namespace adit::dem
