#include "dem_server/model/initial_state/admissible.hpp"

#include <algorithm>
#include <cmath>

#include "dem_server/model/bond_springs.hpp"

namespace adit::dem {
namespace {

constexpr double kGapRounding = 1e-9;  // of a length: gaps below are rounding

const LinearContact& contact_of(const Model& model, std::uint32_t i, std::uint32_t j) {
  return model.contacts[model.contact_number(model.group[i], model.group[j])];
}

PairForces pressed(double friction, const PairForces& wanted) {
  const double normal = std::min(wanted.normal, 0.0), limit = -friction * normal;
  return {normal, std::clamp(wanted.shear, -limit, limit), 0};
}

bool touch(const Discs& d, const Bond& bond) {
  const double distance = std::hypot(d.x[bond.second] - d.x[bond.first], d.y[bond.second] - d.y[bond.first]);
  return distance <= (1 + kGapRounding) * (d.radius[bond.first] + d.radius[bond.second]);
}

PairForces within(const ContactBond& law, const PairForces& wanted) {
  return {std::min(wanted.normal, law.tensile_strength),
          std::clamp(wanted.shear, -law.shear_strength, law.shear_strength), 0};
}

// N w + b |M| is at most w^2 times the tensile strength (laws/parallel_bond.hpp).
PairForces within(const ParallelBond& law, const PairForces& wanted) {
  const double w = law.area(), normal = std::min(wanted.normal, w * law.tensile_strength);
  const double bending = (w * w * law.tensile_strength - w * normal) / ParallelBond::kMomentFactor;
  const double shear = std::max(0.0, law.cohesion * w - normal * law.tan_friction_angle);
  return {normal, std::clamp(wanted.shear, -shear, shear), std::clamp(wanted.moment, -bending, bending)};
}

}  // namespace

PairForces bear(const Model& model, const PairForces& wanted, Bond& bond) {
  switch (bond.law) {
    case Bond::Law::kContactBond:
      return bond.at_rest = within(model.contact_bonds[bond.number], wanted);
    case Bond::Law::kSmoothJoint:
      return bond.at_rest = pressed(model.smooth_joints[bond.number].friction, wanted);
    case Bond::Law::kFacet:  // its own law finds what it cannot bear
      return bond.at_rest = wanted;
    case Bond::Law::kParallelBond:
      break;
  }
  PairForces contact;
  if (touch(model.discs, bond)) {
    const LinearContact& law = contact_of(model, bond.first, bond.second);
    const BondSprings both = whole_springs(model, bond);
    contact = pressed(law.friction, {wanted.normal * law.normal_stiffness / both.kn,
                                     both.ks > 0 ? wanted.shear * law.shear_stiffness / both.ks : 0, 0});
  }
  bond.contact_normal = contact.normal;
  bond.contact_shear = contact.shear;
  bond.at_rest = within(model.parallel_bonds[bond.number],
                        {wanted.normal - contact.normal, wanted.shear - contact.shear, wanted.moment});
  return {bond.at_rest.normal + contact.normal, bond.at_rest.shear + contact.shear, bond.at_rest.moment};
}

PairForces bear(const Model& model, const PairForces& wanted, TouchingPair& pair) {
  const PairForces borne = pressed(contact_of(model, pair.first, pair.second).friction, wanted);
  pair.normal = borne.normal;
  pair.shear = borne.shear;
  return borne;
}

}  // namespace adit::dem
