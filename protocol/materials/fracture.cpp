#include "protocol/materials/fracture.hpp"

#include <fmt/format.h>

#include <cmath>

#include "protocol/errors.hpp"

namespace adit::protocol {

double cohesion_of(const scene::Fracture& fracture, const std::string& path) {
  require(fracture.has_compressive_strength() != fracture.has_cohesion(), path,
          "needs one of compressive_strength and cohesion; give exactly one");
  const double phi = fracture.friction_angle(), tensile = fracture.tensile_strength();
  const double cohesion = fracture.has_cohesion()
                              ? fracture.cohesion()
                              : fracture.compressive_strength() * (1 - std::sin(phi)) / (2 * std::cos(phi));
  require(
      cohesion >= tensile, path + (fracture.has_cohesion() ? ".cohesion" : ".compressive_strength"),
      fmt::format("is too small: it makes the cohesion {:.4g} Pa, below the tensile_strength of {:.4g} Pa; "
                  "give more, as rock and concrete have",
                  cohesion, tensile));
  return cohesion;
}

}  // namespace adit::protocol
