#include "dem_server/particles/displacement_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace adit::dem {

Discs DisplacementBound::start(const Particles& p, std::vector<double> radius) {
  Discs discs{p.x, p.y, std::move(radius)};
  for (std::size_t i = 0; i < p.size(); ++i) {
    discs.x[i] += p.ux[i];
    discs.y[i] += p.uy[i];
  }
  ux_ = p.ux;
  uy_ = p.uy;
  most_ = 0;
  return discs;
}

void DisplacementBound::measure(const Particles& p) {
  double squared = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.ux[i] - ux_[i], y = p.uy[i] - uy_[i];
    squared = std::max(squared, x * x + y * y);
  }
  most_ = std::sqrt(squared);
}

}  // namespace adit::dem
