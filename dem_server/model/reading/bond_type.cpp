#include "dem_server/model/reading/bond_type.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem_server/model/placement/groups.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

double checked(double value, const std::string& path, bool may_be_zero, const std::string& unit = "") {
  if (!(may_be_zero ? value >= 0 : value > 0) || std::isnan(value))
    throw UserError(path, fmt::format("is {}{}{}; give a number {}", value, unit.empty() ? "" : " ", unit,
                                      may_be_zero ? "from 0" : "above 0"));
  return value;
}

ParallelBond read_parallel(const scene::ParallelBonds& bonds, const std::string& path) {
  return {checked(bonds.normal_stiffness(), path + ".normal_stiffness", false, "Pa/m"),
          checked(bonds.shear_stiffness(), path + ".shear_stiffness", true, "Pa/m"),
          checked(bonds.width(), path + ".width", false),
          checked(bonds.tensile_strength(), path + ".tensile_strength", false, "Pa"),
          checked(bonds.cohesion(), path + ".cohesion", false, "Pa"),
          std::tan(checked(bonds.friction_angle(), path + ".friction_angle", true, "rad"))};
}

ContactBond between(const ContactBond& a, const ContactBond& b) {
  return {in_series(a.normal_stiffness, b.normal_stiffness), in_series(a.shear_stiffness, b.shear_stiffness),
          std::min(a.tensile_strength, b.tensile_strength), std::min(a.shear_strength, b.shear_strength)};
}

ParallelBond between(const ParallelBond& a, const ParallelBond& b) {
  return {in_series(a.normal_stiffness, b.normal_stiffness),
          in_series(a.shear_stiffness, b.shear_stiffness),
          std::min(a.radius, b.radius),
          std::min(a.tensile_strength, b.tensile_strength),
          std::min(a.cohesion, b.cohesion),
          std::min(a.tan_friction_angle, b.tan_friction_angle)};
}

}  // namespace

BondType read_bond_type(const scene::Bonds& bonds, const std::string& path,
                        const std::function<BondStiffness()>& otherwise) {
  const double reach = checked(bonds.reach(), path + ".reach", true);
  if (bonds.has_parallel()) {
    for (const auto& [given, name] : {std::pair{bonds.has_tensile_strength(), "tensile_strength"},
                                      std::pair{bonds.has_shear_strength(), "shear_strength"}})
      if (given)
        throw UserError(path + "." + name,
                        "is given beside `parallel`, whose cement alone carries tension; give the strengths "
                        "there, in Pa");
    return {read_parallel(bonds.parallel(), path + ".parallel"), reach};
  }
  ContactBond law{bonds.normal_stiffness(), bonds.shear_stiffness(),
                  checked(bonds.tensile_strength(), path + ".tensile_strength", false, "N"),
                  checked(bonds.shear_strength(), path + ".shear_strength", false, "N")};
  if (!bonds.has_normal_stiffness() || !bonds.has_shear_stiffness()) {
    const BondStiffness other = otherwise();
    if (!bonds.has_normal_stiffness()) law.normal_stiffness = other.normal;
    if (!bonds.has_shear_stiffness()) law.shear_stiffness = other.shear;
  }
  checked(law.normal_stiffness, path + ".normal_stiffness", false, "N/m");
  checked(law.shear_stiffness, path + ".shear_stiffness", true, "N/m");
  return {law, reach};
}

BondType read_smooth_joint(const scene::SmoothJoint& joint, double reach, const std::string& path) {
  return {SmoothJoint{checked(joint.normal_stiffness(), path + ".normal_stiffness", false, "Pa/m"),
                      checked(joint.shear_stiffness(), path + ".shear_stiffness", false, "Pa/m"),
                      checked(joint.friction(), path + ".friction", true),
                      std::tan(checked(joint.dilation(), path + ".dilation", true, "rad")), 1},
          reach};
}

std::optional<BondType> between(const BondType& a, const BondType& b) {
  const double reach = std::min(a.reach, b.reach);
  if (const auto* one = std::get_if<ContactBond>(&a.law), *other = std::get_if<ContactBond>(&b.law);
      one && other)
    return BondType{between(*one, *other), reach};
  if (const auto* one = std::get_if<ParallelBond>(&a.law), *other = std::get_if<ParallelBond>(&b.law);
      one && other)
    return BondType{between(*one, *other), reach};
  return std::nullopt;
}

}  // namespace adit::dem
