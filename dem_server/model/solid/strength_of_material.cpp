#include "dem_server/model/solid/strength_of_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

double compressive_strength(const MaterialStrength& strength) {
  return 2 * strength.cohesion * std::cos(strength.friction_angle) / (1 - std::sin(strength.friction_angle));
}

// The tension in which the cone of cohesion and friction ends.
double apex(const scene::MohrCoulomb& law) {
  return law.friction_angle() > 0 ? law.cohesion() / std::tan(law.friction_angle()) : kUnbreakable;
}

}  // namespace

MaterialStrength strength_of(const MaterialAt& material, const std::string& path) {
  if (!material.material.has_mohr_coulomb())
    throw UserError(path, "is set, but " + material.path +
                              " has no mohr_coulomb; give its cohesion, friction_angle and tension, or leave "
                              "this out");
  const auto& law = material.material.mohr_coulomb();
  const double most = apex(law);
  const MaterialStrength strength{law.has_tension() ? std::min(law.tension(), most) : most, law.cohesion(),
                                  law.friction_angle()};
  for (const auto& [value, name] : {std::pair{strength.tension, ".mohr_coulomb.tension"},
                                    std::pair{strength.cohesion, ".mohr_coulomb.cohesion"}})
    if (!(value > 0))
      throw UserError(material.path + name,
                      "is 0, but " + path + " makes it the strength of bonds; give more");
  return strength;
}

std::optional<std::string> note_on_cut_tension(const MaterialAt& material) {
  constexpr double kNoticed = 1.01;
  const auto& law = material.material.mohr_coulomb();
  const double most = apex(law);
  if (!law.has_tension() || law.tension() <= kNoticed * most) return std::nullopt;
  return fmt::format(
      "{}.mohr_coulomb.tension: is {:.3g} Pa, but bonds get {:.3g} Pa, cohesion / tan(friction_angle), where "
      "the "
      "cone ends; a larger tension needs more cohesion",
      material.path, law.tension(), most);
}

MaterialStrength weaker(const MaterialStrength& a, const MaterialStrength& b) {
  return {std::min(a.tension, b.tension), std::min(a.cohesion, b.cohesion),
          std::min(a.friction_angle, b.friction_angle)};
}

ContactBond with_strength(const MaterialStrength& strength, double radius, const ContactBond& law) {
  const auto [kn, ks] = law.stiffness;
  ContactBond strong = law;
  strong.tensile_strength = strength.tension * radius * (3 * kn + ks) / (std::numbers::sqrt3 * (kn + ks));
  strong.shear_strength = compressive_strength(strength) * radius * ks / (kn + ks);
  return strong;
}

ParallelBond with_strength(const MaterialStrength& strength, const ParallelBond& law) {
  ParallelBond strong = law;
  strong.tensile_strength = strength.tension;
  strong.cohesion = strength.cohesion;
  strong.tan_friction_angle = std::tan(strength.friction_angle);
  return strong;
}

}  // namespace adit::dem
