#include "dem_server/engines/general/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace adit::dem {
namespace {

PairLaw law_of(const Model& model, const Joined& joined, std::uint32_t contact) {
  PairLaw law{.contact = model.contacts[contact]};
  if (joined.law == Joined::Law::kContactBond) {
    const ContactBond& bond = model.contact_bonds[joined.number];
    law.kn = bond.normal_stiffness;
    law.ks = bond.shear_stiffness;
    law.tensile_strength = bond.tensile_strength;
    law.cohesion = bond.shear_strength;
  } else {
    const ParallelBond& bond = model.parallel_bonds[joined.number];
    law.kn = bond.normal_stiffness;
    law.ks = bond.shear_stiffness;
    law.km = bond.normal_stiffness / 12;
    law.tensile_strength = bond.tensile_strength;
    law.bending = 6;
    law.cohesion = bond.cohesion;
    law.tan_friction_angle = bond.tan_friction_angle;
    law.beside = true;
  }
  return law;
}

}  // namespace

Particles particles_of(const Model& model, std::span<const double> weights) {
  Particles p;
  const std::size_t size = model.discs.size();
  p.x = model.discs.x;
  p.y = model.discs.y;
  for (auto* zeroed :
       {&p.ux, &p.uy, &p.settled_x, &p.settled_y, &p.vx, &p.vy, &p.spin, &p.fx, &p.fy, &p.moment})
    zeroed->assign(size, 0.0);
  for (std::uint32_t i = 0; i < size; ++i) {
    const double weight = weights.empty() ? 1 : weights[i];
    p.id.push_back(i);
    p.weight.push_back(weight);
    p.mass.push_back(weight * model.mass[i]);
    p.inertia.push_back(weight * model.inertia[i]);
    p.inverse_mass.push_back(1 / p.mass[i]);
    p.inverse_inertia.push_back(1 / p.inertia[i]);
  }
  return p;
}

Bonded bonds_of(const Model& model, std::span<const double> weights) {
  Bonded out;
  const auto groups = static_cast<std::uint32_t>(std::max<std::size_t>(model.group_names.size(), 1));
  const Discs& d = model.discs;
  std::map<std::tuple<Joined::Law, std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
  std::vector<std::uint32_t> laws;
  for (std::uint32_t k = 0; k < model.joined.size(); ++k) {
    const Joined& pair = model.joined[k];
    const double weight = weights.empty() ? 1 : weights[k];
    if (pair.law == Joined::Law::kSmoothJoint) {
      out.joints.push_back({pair.first, pair.second, pair.nx, pair.ny,
                            (d.radius[pair.first] - d.radius[pair.second]) / 2, weight,
                            model.smooth_joints[pair.number]});
      continue;
    }
    const std::uint32_t contact = model.group[pair.first] * groups + model.group[pair.second];
    const auto [found, fresh] = numbers.try_emplace({pair.law, pair.number, contact});
    if (fresh) {
      const PairLaw law = law_of(model, pair, contact);
      found->second = static_cast<std::uint32_t>(std::ranges::find(out.laws, law) - out.laws.begin());
      if (found->second == out.laws.size()) out.laws.push_back(law);
    }
    laws.push_back(found->second);
    out.bonds.first.push_back(pair.first);
    out.bonds.second.push_back(pair.second);
    out.joined_of_bond.push_back(k);
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
    const Joined& joined = model.joined[out.joined_of_bond[k]];
    bonds.width[k] = law.beside ? model.parallel_bonds[joined.number].area() : 1;
    bonds.rest_x[k] = x;
    bonds.rest_y[k] = y;
    bonds.rest_length[k] = length;
    bonds.half_difference[k] = (d.radius[i] - d.radius[j]) / 2;
    bonds.slack[k] = model.overlaps_free ? std::max(gap, 0.0) : gap;
    // Rounding of places is no gap.
    if (std::abs(bonds.slack[k]) < 1e-12 * length) bonds.slack[k] = 0;
    if (!law.beside) bonds.initial[k] = law.kn * std::min(bonds.slack[k], 0.0);
    if (!weights.empty()) bonds.weight[k] = weights[out.joined_of_bond[k]];
  }
  bonds.sort_chunks();
  return out;
}

}  // namespace adit::dem
