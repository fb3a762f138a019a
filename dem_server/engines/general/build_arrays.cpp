#include "dem_server/engines/general/build_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "dem_server/laws/linear_contact.hpp"

namespace adit::dem {
namespace {

PairLaw law_of(const Model& model, const Bond& joined, std::uint32_t contact) {
  PairLaw law{.contact = model.contacts[contact]};
  if (joined.law == Bond::Law::kContactBond) {
    const BondFactors& factors = model.contact_bonds[joined.number].factors;
    const ContactBond bond = scaled(model.contact_bonds[joined.number], factors);
    law.contact.normal_stiffness *= factors.stiffness;
    law.kn = bond.stiffness.normal;
    law.ks = bond.stiffness.shear;
    law.tensile_strength = bond.tensile_strength;
    law.cohesion = bond.shear_strength;
  } else {
    const ParallelBond& bond = model.parallel_bonds[joined.number];
    law.kn = bond.normal_stiffness;
    law.ks = bond.shear_stiffness;
    law.km = bond.moment_stiffness();
    law.tensile_strength = bond.tensile_strength;
    law.moment_factor = ParallelBond::kMomentFactor;
    law.cohesion = bond.cohesion;
    law.tan_friction_angle = bond.tan_friction_angle;
    law.contact_beside_bond = true;
  }
  return law;
}

Joints::Joint joint_of(const Model& model, const Bond& bond) {
  const SmoothJoint& law = model.smooth_joints[bond.number];
  return {.first = bond.first,
          .second = bond.second,
          .nx = bond.nx,
          .ny = bond.ny,
          .half_difference = (model.discs.radius[bond.first] - model.discs.radius[bond.second]) / 2,
          .weight = bond.weight,
          .law = law,
          .displacement = bond.at_rest.normal / (law.normal_stiffness * law.length),
          .springs = {.shear = bond.at_rest.shear},
          .normal = bond.at_rest.normal};
}

// Forces at rest. Where a contact bond breaks, its contact is pressed by what the bond was; the contact
// beside a parallel bond starts with its own part.
void set_forces_at_rest(const PairLaw& law, const Bond& bond, std::uint32_t k, Pairs& bonds) {
  if (bond.at_rest == PairForces{} && bond.contact_normal == 0) return;
  bonds.initial[k] = bond.at_rest.normal;
  bonds.shear[k] = bond.at_rest.shear;
  bonds.moment[k] = bond.at_rest.moment;
  bonds.slide[k] = bond.contact_shear;
  const double pressing = law.contact_beside_bond ? bond.contact_normal : std::min(bond.at_rest.normal, 0.0);
  if (pressing < 0)
    bonds.slack[k] = pressing / law.contact.normal_stiffness;
  else
    bonds.slack[k] += bond.at_rest.normal / (law.kn * bonds.width[k]);
}

}  // namespace

std::vector<Pair> pairs_of(const std::vector<Bond>& bonds) {
  std::vector<Pair> pairs;
  for (const Bond& bond : bonds) pairs.push_back({bond.first, bond.second});
  return pairs;
}

Bonded bonds_of(const Model& model) {
  Bonded out;
  const Discs& d = model.discs;
  std::map<std::tuple<Bond::Law, std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
  std::map<PairLaw, std::uint32_t> known;
  std::vector<std::uint32_t> laws;
  for (std::uint32_t k = 0; k < model.bonds.size(); ++k) {
    const Bond& pair = model.bonds[k];
    if (pair.law == Bond::Law::kSmoothJoint) {
      out.joints.push_back(joint_of(model, pair));
      continue;
    }
    if (pair.law == Bond::Law::kFacet) continue;  // facets/facets.hpp
    const std::uint32_t contact = model.contact_number(model.group[pair.first], model.group[pair.second]);
    const auto [found, fresh] = numbers.try_emplace({pair.law, pair.number, contact});
    if (fresh) {
      const PairLaw law = law_of(model, pair, contact);
      const auto [same, is_new] = known.try_emplace(law, static_cast<std::uint32_t>(out.laws.size()));
      if (is_new) out.laws.push_back(law);
      found->second = same->second;
    }
    laws.push_back(found->second);
    out.bonds.first.push_back(pair.first);
    out.bonds.second.push_back(pair.second);
    out.bond_of_pair.push_back(k);
  }
  out.first_contact_law = static_cast<std::uint32_t>(out.laws.size());
  for (const LinearContact& contact : model.contacts) {
    out.laws.push_back({.contact = contact});
    out.dashpots |= contact.normal_damping > 0 || contact.shear_damping > 0;
  }

  Pairs& bonds = out.bonds;
  bonds.finish(d.size(), true, out.dashpots);
  bonds.law = std::move(laws);
  for (std::uint32_t k = 0; k < bonds.size(); ++k) {
    const std::uint32_t i = bonds.first[k], j = bonds.second[k];
    const double x = d.x[j] - d.x[i], y = d.y[j] - d.y[i], length = std::sqrt(x * x + y * y);
    const double gap = length - d.radius[i] - d.radius[j];
    const PairLaw& law = out.laws[bonds.law[k]];
    const Bond& bond = model.bonds[out.bond_of_pair[k]];
    bonds.width[k] = law.contact_beside_bond ? model.parallel_bonds[bond.number].area() : 1;
    bonds.rest_x[k] = x;
    bonds.rest_y[k] = y;
    bonds.rest_length[k] = length;
    bonds.half_difference[k] = (d.radius[i] - d.radius[j]) / 2;
    bonds.slack[k] = model.overlaps_free ? std::max(gap, 0.0) : gap;
    // Rounding of places is no gap.
    if (std::abs(bonds.slack[k]) < 1e-12 * length) bonds.slack[k] = 0;
    if (!law.contact_beside_bond) bonds.initial[k] = contact_normal_force(law.kn, bonds.slack[k]);
    set_forces_at_rest(law, bond, k, bonds);
    bonds.weight[k] = bond.weight;
  }
  bonds.sort_chunks(out.laws);
  return out;
}

}  // namespace adit::dem
