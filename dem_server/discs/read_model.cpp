#include "dem_server/discs/read_model.hpp"

#include "dem_server/packing/square.hpp"
#include "dem_server/scene_checks.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {

bool needs_discs(const scene::Particles& p) {
  return !p.has_packing() || p.bonds().has_parallel() || p.bonds().has_reach() || p.has_within() ||
         p.has_ring() || p.groups_size() > 0 || p.between_size() > 0 || p.joints_size() > 0 ||
         p.springs_size() > 0 || p.has_contacts() || p.walls_size() > 0 || p.quiet_size() > 0 ||
         p.has_damping();
}

Model read_model(const scene::Scene& scene) {
  const scene::Particles& p = scene.particles();
  Model model;
  const BondLaw law = checked_bond_law(scene);
  const double radius = p.has_packing() ? p.packing().radius() : p.square_packing().radius();
  if (p.has_packing()) {
    const Packing packing = checked_packing(scene);
    model.discs = {packing.x, packing.y, std::vector(packing.x.size(), radius)};
  } else if (p.has_square_packing()) {
    const auto& box = p.square_packing();
    model.discs = pack_squarely({box.x_min(), box.x_max(), box.y_min(), box.y_max()}, radius);
  } else {
    throw protocol::UserError("particles", "has a packing that is not computed yet");
  }
  const std::size_t size = model.discs.size();
  model.mass.assign(size, cell_mass(material_of(scene).density(), radius));
  model.inertia.assign(size, model.mass[0] * radius * radius / 2);
  model.group.assign(size, 0);
  model.group_names = {""};
  LinearContact contact{law.stiffness.normal, law.stiffness.shear, p.contacts().friction(),
                        p.contacts().normal_damping(), p.contacts().shear_damping()};
  if (p.contacts().has_normal_stiffness()) contact.normal_stiffness = p.contacts().normal_stiffness();
  if (p.contacts().has_shear_stiffness()) contact.shear_stiffness = p.contacts().shear_stiffness();
  model.contacts = {contact};
  if (p.has_bonds()) {
    const auto& parallel = p.bonds().parallel();
    if (p.bonds().has_parallel())
      model.parallel_bonds = {{parallel.normal_stiffness(), parallel.shear_stiffness(),
                               parallel.width() * radius, parallel.tensile_strength(), parallel.cohesion(),
                               std::tan(parallel.friction_angle())}};
    else
      model.contact_bonds = {
          {law.stiffness.normal, law.stiffness.shear, law.tensile_strength, law.shear_strength}};
    for (const Pair& pair : pairs_within(model.discs, p.bonds().reach() * radius))
      model.joined.push_back(
          {pair.first, pair.second,
           p.bonds().has_parallel() ? Joined::Law::kParallelBond : Joined::Law::kContactBond, 0});
  }
  for (const auto& wall : p.walls()) {
    const auto& own = wall.contacts();
    LinearContact touch = contact;
    if (own.has_normal_stiffness()) touch.normal_stiffness = own.normal_stiffness();
    if (own.has_shear_stiffness()) touch.shear_stiffness = own.shear_stiffness();
    if (own.has_friction()) touch.friction = own.friction();
    if (own.has_normal_damping()) touch.normal_damping = own.normal_damping();
    if (own.has_shear_damping()) touch.shear_damping = own.shear_damping();
    model.walls.push_back({wall.name(), wall.from().x(), wall.from().y(), wall.to().x(), wall.to().y(), touch,
                           wall.velocity().x(), wall.velocity().y(), wall.velocity().time()});
  }
  model.local_damping = p.damping().local();
  model.viscous_damping = p.damping().viscous();
  return model;
}

}  // namespace adit::dem
