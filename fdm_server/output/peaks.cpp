#include "fdm_server/output/peaks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdm_server/output/mean_strain.hpp"

namespace adit::fdm {

namespace {

// Velocities of every point; those of the columns are the last and are not used.
protocol::PlaneVectors velocities(const Continuum& continuum, std::size_t points) {
  return {continuum.vx().first(points), continuum.vy().first(points)};
}

}  // namespace

Peaks::Peaks(const Grid& grid)
    : points_(grid.own_points()),
      motion_(points_),
      shear_strain_(grid.own_zones()),
      largest_principal_(grid.own_zones(), -std::numeric_limits<double>::infinity()),
      smallest_principal_(grid.own_zones(), std::numeric_limits<double>::infinity()) {
  gradients_.reserve(grid.own_zones());
  for (std::size_t z = 0; z < grid.own_zones(); ++z) gradients_.push_back(mean_gradient(corners(grid, z)));
}

void Peaks::remember(const Continuum& continuum) {
  motion_.remember(velocities(continuum, points_));
}

void Peaks::take(const Grid& grid, const Continuum& continuum, const protocol::Step& step) {
  const auto ux = continuum.ux(), uy = continuum.uy();
  motion_.take([&](std::size_t i) { return std::array{ux[i], uy[i]}; }, velocities(continuum, points_), step);
  const auto radius = [](double difference, double twice_shear) {  // of Mohr's circle, twice
    return std::sqrt(difference * difference + twice_shear * twice_shear);
  };
  for (std::size_t z = 0; z < gradients_.size(); ++z) {
    const MeanStrain e = mean_strain(gradients_[z], grid.zones[z], ux, uy);
    shear_strain_[z] = std::max(shear_strain_[z], radius(e.xx - e.yy, e.xy));
    const Stress s = continuum.zones().stress(z);
    const double mean = (s.xx + s.yy) / 2, deviator = radius(s.xx - s.yy, 2 * s.xy) / 2;
    largest_principal_[z] = std::max(largest_principal_[z], mean + deviator);
    smallest_principal_[z] = std::min(smallest_principal_[z], mean - deviator);
  }
}

}  // namespace adit::fdm
