#include "dem_server/lining/envelope.hpp"

namespace adit::dem {

void Envelope::take(std::span<const SectionForces> forces, double time) {
  const bool first = largest_[0].empty();
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const std::array now{forces[k].thrust, forces[k].moment, forces[k].shear};
    for (std::size_t f = 0; f < now.size(); ++f) {
      if (first) {
        largest_[f].push_back({now[f], time});
        smallest_[f].push_back({now[f], time});
        continue;
      }
      if (now[f] > largest_[f][k].value) largest_[f][k] = {now[f], time};
      if (now[f] < smallest_[f][k].value) smallest_[f][k] = {now[f], time};
    }
  }
}

}  // namespace adit::dem
