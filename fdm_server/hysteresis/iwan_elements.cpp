#include "fdm_server/hysteresis/iwan_elements.hpp"

#include <cstddef>

namespace adit::fdm {

// An element that yields takes its stiffness out of the sum, so it is the change of slope at its vertex.
IwanElements iwan_elements(std::span<const BackbonePoint> backbone) {
  IwanElements elements;
  double slope = 1;
  for (std::size_t k = 0; k < backbone.size(); ++k) {
    const double next = k + 1 < backbone.size() ? (backbone[k + 1].stress - backbone[k].stress) /
                                                      (backbone[k + 1].strain - backbone[k].strain)
                                                : 0;
    elements.stiffness.push_back(slope - next);
    elements.limit.push_back(backbone[k].strain);
    slope = next;
  }
  return elements;
}

}  // namespace adit::fdm
