#include "dem_server/model/solid/facets_of_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/materials/fracture.hpp"

namespace adit::dem {

using protocol::UserError;

CellElasticity elasticity_of(const MaterialAt& at, Plane plane) {
  const double nu = at.material.poisson_ratio();
  if (!(nu >= 0 && nu <= kLargestPoissonRatio))
    throw UserError(at.path + ".poisson_ratio",
                    fmt::format("is {}, but cells deform like a solid only from 0 to {}; change it", nu,
                                kLargestPoissonRatio));
  return cell_elasticity(at.material.young_modulus(), nu, plane);
}

FacetLaw fracture_of(const scene::Fracture& fracture, const std::string& path) {
  const double phi = fracture.friction_angle();
  const double cohesion = protocol::cohesion_of(fracture, path);
  if (fracture.residual_friction_angle() > phi)
    throw UserError(path + ".residual_friction_angle", "is above friction_angle; give at most that");
  const double opening = fracture.fracture_energy();
  return {fracture.tensile_strength(),
          cohesion,
          std::tan(phi),
          std::tan(fracture.residual_friction_angle()),
          opening,
          fracture.has_shearing_energy() ? fracture.shearing_energy() : 3 * opening,
          true,
          fracture.rate_exponent()};
}

double compressive_strength(const FacetLaw& law) {
  const double phi = std::atan(law.friction);
  return 2 * law.cohesion * std::cos(phi) / (1 - std::sin(phi));
}

FacetLaw touching(double stiffness, double friction) {
  constexpr double kNone = 1e-9, kAtOnce = 1e-200;  // energy by which it is worn away whatever it does first
  const double none = kNone * stiffness;
  return {.tensile_strength = none,
          .cohesion = none,
          .friction = friction,
          .residual_friction = friction,
          .opening_energy = kAtOnce,
          .shearing_energy = kAtOnce,
          .joined = false};
}

FacetLaw unbroken() {
  return {kUnbroken, kUnbroken, 0, 0, kUnbroken, kUnbroken};
}

FacetLaw weaker(const FacetLaw& a, const FacetLaw& b) {
  return {std::min(a.tensile_strength, b.tensile_strength),
          std::min(a.cohesion, b.cohesion),
          std::min(a.friction, b.friction),
          std::min(a.residual_friction, b.residual_friction),
          std::min(a.opening_energy, b.opening_energy),
          std::min(a.shearing_energy, b.shearing_energy),
          true,
          std::min(a.rate_exponent, b.rate_exponent)};
}

}  // namespace adit::dem
