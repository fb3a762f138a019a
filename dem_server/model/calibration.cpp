#include "dem_server/model/calibration.hpp"

#include <numbers>

namespace adit::dem {

CellElasticity cell_elasticity(double young_modulus, double poisson_ratio, Plane plane) {
  double e = young_modulus, nu = poisson_ratio;
  if (plane == Plane::kStrain) {
    e /= 1 - nu * nu;
    nu /= 1 - nu;
  }
  return {e / (1 + nu), e * nu / (1 - nu * nu)};
}

BondStiffness calibrate(double young_modulus, double poisson_ratio, Plane plane) {
  const auto [twice_mu, lambda] = cell_elasticity(young_modulus, poisson_ratio, plane);
  const double mu = twice_mu / 2, factor = 2 / std::numbers::sqrt3;
  return {factor * (mu + lambda), factor * (mu - lambda)};
}

double largest_poisson_ratio(Plane plane) {
  return plane == Plane::kStress ? 1.0 / 3 : 1.0 / 4;
}

double cell_mass(double density, double radius) {
  return density * 2 * std::numbers::sqrt3 * radius * radius;
}

}  // namespace adit::dem
