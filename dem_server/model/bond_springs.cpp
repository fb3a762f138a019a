#include "dem_server/model/bond_springs.hpp"

#include <algorithm>

namespace adit::dem {

const LinearContact& contact_of(const Model& model, const Bond& bond) {
  return model.contacts[model.contact_number(model.group[bond.first], model.group[bond.second])];
}

namespace {

BondSprings whole_springs(const Model& model, const Bond& bond, const LinearContact& contact) {
  switch (bond.law) {
    case Bond::Law::kContactBond: {
      const ContactBond& law = model.contact_bonds[bond.number];
      const auto [normal, shear] = scaled(law, law.factors).stiffness;
      return {normal, shear};
    }
    case Bond::Law::kParallelBond: {
      const ParallelBond& law = model.parallel_bonds[bond.number];
      return {law.normal_stiffness * law.area() + contact.normal_stiffness,
              law.shear_stiffness * law.area() + contact.shear_stiffness,
              law.normal_stiffness * law.second_moment()};
    }
    case Bond::Law::kSmoothJoint: {
      const SmoothJoint& law = model.smooth_joints[bond.number];
      return {law.normal_stiffness * law.length, law.shear_stiffness * law.length};
    }
    case Bond::Law::kFacet: {
      const FacetBond& facet = model.facets[bond.number];
      const double k = facet.stiffness * facet.length;
      return {k, k, k * facet.length * facet.length / 12};
    }
  }
  return {};
}

}  // namespace

BondSprings whole_springs(const Model& model, const Bond& bond) {
  return whole_springs(model, bond, contact_of(model, bond));
}

bool is_breakable(const Model& model, const Bond& bond) {
  switch (bond.law) {
    case Bond::Law::kContactBond: {
      const ContactBond& law = model.contact_bonds[bond.number];
      return law.tensile_strength < kUnbreakable || law.shear_strength < kUnbreakable;
    }
    case Bond::Law::kParallelBond: {
      const ParallelBond& law = model.parallel_bonds[bond.number];
      return law.tensile_strength < kUnbreakable || law.cohesion < kUnbreakable;
    }
    case Bond::Law::kFacet:
      return model.facet_laws[model.facets[bond.number].law].breaks();
    case Bond::Law::kSmoothJoint:
      return false;
  }
  return false;
}

std::size_t breakable_bonds(const Model& model) {
  const auto count = [&](const std::vector<Bond>& bonds) {
    return std::ranges::count_if(bonds, [&](const Bond& bond) { return is_breakable(model, bond); });
  };
  auto most = count(model.bonds);
  for (const ParticleStage& stage : model.stages) most = std::max(most, count(stage.bonds));
  return static_cast<std::size_t>(most);
}

BondSprings stiffest_springs(const Model& model, const Bond& bond) {
  return stiffest_springs(model, bond, contact_of(model, bond));
}

BondSprings stiffest_springs(const Model& model, const Bond& bond, const LinearContact& contact) {
  BondSprings springs = whole_springs(model, bond, contact);
  if (bond.law == Bond::Law::kContactBond) {  // the contact takes its place when it breaks
    const double factor = model.contact_bonds[bond.number].factors.stiffness;
    springs.kn = std::max(springs.kn, contact.normal_stiffness * factor);
    springs.ks = std::max(springs.ks, contact.shear_stiffness);
  } else if (bond.law == Bond::Law::kSmoothJoint) {  // its two springs pull in any direction
    const SmoothJoint& law = model.smooth_joints[bond.number];
    springs.kn = springs.ks = (law.normal_stiffness + law.shear_stiffness) * law.length;
  }
  return springs;
}

}  // namespace adit::dem
