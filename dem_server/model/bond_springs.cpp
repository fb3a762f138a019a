#include "dem_server/model/bond_springs.hpp"

#include <algorithm>

namespace adit::dem {

BondSprings stiffest_springs(const Model& model, const Bond& bond) {
  const LinearContact& contact =
      model.contacts[model.contact_number(model.group[bond.first], model.group[bond.second])];
  switch (bond.law) {
    case Bond::Law::kContactBond: {
      const ContactBond& law = model.contact_bonds[bond.number];
      return {std::max(law.normal_stiffness, contact.normal_stiffness),
              std::max(law.shear_stiffness, contact.shear_stiffness)};
    }
    case Bond::Law::kParallelBond: {
      const ParallelBond& law = model.parallel_bonds[bond.number];
      return {law.normal_stiffness * law.area() + contact.normal_stiffness,
              law.shear_stiffness * law.area() + contact.shear_stiffness,
              law.normal_stiffness * law.second_moment()};
    }
    case Bond::Law::kSmoothJoint: {  // its two springs pull in any direction
      const SmoothJoint& law = model.smooth_joints[bond.number];
      const double both = (law.normal_stiffness + law.shear_stiffness) * law.length;
      return {both, both};
    }
  }
  return {};
}

}  // namespace adit::dem
