#include "fdm_server/supports/peak_forces.hpp"

#include <algorithm>
#include <cmath>

namespace adit::fdm {

std::size_t PeakForces::nodes_of(std::span<const Lining> linings) {
  std::size_t nodes = 0;
  for (const Lining& lining : linings) nodes += lining.path.points.size();
  return nodes;
}

void PeakForces::take(std::span<const Lining> linings, const Structures& structures) {
  if (values_[0].empty())
    for (auto& column : values_) column.resize(nodes_of(linings), 0.0);
  std::size_t row = 0;
  for (const Lining& lining : linings)
    for (std::size_t node = 0; node < lining.path.points.size(); ++node, ++row) {
      const auto [thrust, moment, shear] = forces_at(lining, structures, node);
      values_[0][row] = std::max(values_[0][row], std::abs(thrust));
      values_[1][row] = std::max(values_[1][row], std::abs(moment));
      values_[2][row] = std::max(values_[2][row], std::abs(shear));
    }
}

}  // namespace adit::fdm
