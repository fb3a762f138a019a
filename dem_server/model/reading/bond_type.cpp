#include "dem_server/model/reading/bond_type.hpp"

#include <algorithm>
#include <cmath>

#include "dem_server/model/placement/groups.hpp"
#include "dem_server/model/solid/facets_of_material.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

ParallelBond read_parallel(const scene::ParallelBonds& bonds) {
  return {bonds.normal_stiffness(), bonds.shear_stiffness(), bonds.width(),
          bonds.tensile_strength(), bonds.cohesion(),        std::tan(bonds.friction_angle())};
}

ContactBond between(const ContactBond& a, const ContactBond& b) {
  return {in_series(a.stiffness, b.stiffness), std::min(a.tensile_strength, b.tensile_strength),
          std::min(a.shear_strength, b.shear_strength)};
}

ParallelBond between(const ParallelBond& a, const ParallelBond& b) {
  return {in_series(a.normal_stiffness, b.normal_stiffness),
          in_series(a.shear_stiffness, b.shear_stiffness),
          std::min(a.radius, b.radius),
          std::min(a.tensile_strength, b.tensile_strength),
          std::min(a.cohesion, b.cohesion),
          std::min(a.tan_friction_angle, b.tan_friction_angle)};
}

struct Given {
  bool given;
  std::string name;
};

// Strengths of bonds come from their material or from the scene, not from both.
void refuse_strengths_given_twice(const scene::Bonds& bonds, const std::string& path) {
  const auto& cement = bonds.parallel();
  for (const auto& [given, name] : {Given{bonds.has_tensile_strength(), "tensile_strength"},
                                    Given{bonds.has_shear_strength(), "shear_strength"},
                                    Given{cement.has_tensile_strength(), "parallel.tensile_strength"},
                                    Given{cement.has_cohesion(), "parallel.cohesion"},
                                    Given{cement.has_friction_angle(), "parallel.friction_angle"}})
    if (given)
      throw UserError(
          path + "." + name,
          "is given beside strength_of_material, which takes the strengths from the material; leave "
          "out one of the two");
}

BondType with_strength_of_material(const BondType& type, const std::string& path, const BondSource& source) {
  const MaterialStrength strength = source.strength(path);
  if (const auto* cement = std::get_if<ParallelBond>(&type.law))
    return {with_strength(strength, *cement), type.reach};
  if (!source.lattice_radius)
    throw UserError(path,
                    "is set, but the strengths of contact bonds are known for a hexagonal packing only; give "
                    "tensile_strength and shear_strength, or parallel bonds");
  return {with_strength(strength, *source.lattice_radius, std::get<ContactBond>(type.law)), type.reach};
}

BondType read_without_material(const scene::Bonds& bonds, const std::string& path, const BondSource& source) {
  const double reach = bonds.has_reach() ? bonds.reach() : source.reach;
  if (bonds.has_parallel()) {
    for (const auto& [given, name] : {std::pair{bonds.has_tensile_strength(), "tensile_strength"},
                                      std::pair{bonds.has_shear_strength(), "shear_strength"}})
      if (given)
        throw UserError(path + "." + name,
                        "is given beside `parallel`, whose cement alone carries tension; give the strengths "
                        "there, in Pa");
    return {read_parallel(bonds.parallel()), reach};
  }
  ContactBond law{
      {bonds.normal_stiffness(), bonds.shear_stiffness()}, bonds.tensile_strength(), bonds.shear_strength()};
  if (!bonds.has_normal_stiffness() || !bonds.has_shear_stiffness()) {
    const BondStiffness other = source.stiffness();
    if (!bonds.has_normal_stiffness()) law.stiffness.normal = other.normal;
    if (!bonds.has_shear_stiffness()) law.stiffness.shear = other.shear;
  }
  return {law, reach};
}

}  // namespace

BondType read_bond_type(const scene::Bonds& bonds, const std::string& path, const BondSource& source) {
  if (bonds.has_fracture())
    throw UserError(path + ".fracture",
                    "is given, but only facets between `cells` break by it; give tensile_strength and "
                    "shear_strength, or pack `cells`");
  if (!bonds.strength_of_material()) return read_without_material(bonds, path, source);
  refuse_strengths_given_twice(bonds, path);
  return with_strength_of_material(read_without_material(bonds, path, source), path + ".strength_of_material",
                                   source);
}

BondType read_smooth_joint(const scene::SmoothJoint& joint, double reach) {
  return {SmoothJoint{joint.normal_stiffness(), joint.shear_stiffness(), joint.friction(),
                      std::tan(joint.dilation()), 1},
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
  if (const auto* one = std::get_if<FacetType>(&a.law), *other = std::get_if<FacetType>(&b.law); one && other)
    return BondType{FacetType{in_series(one->stiffness, other->stiffness), weaker(one->law, other->law)},
                    reach};
  return std::nullopt;
}

}  // namespace adit::dem
