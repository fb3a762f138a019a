#include "coupler/tunnel/region.hpp"

#include <cmath>
#include <numbers>

namespace adit::coupler {
namespace {

// The packing lies in the middle of its box. An odd number of rows puts a whole one at half the height, so
// that the lattice is symmetric about both axes of the box.
scene::HexagonalPacking packing_over(const geometry::BoundingBox& box, double radius) {
  const double margin = 2 * radius, row = std::numbers::sqrt3 * radius;
  const double middle_x = (box.x_min + box.x_max) / 2, middle_y = (box.y_min + box.y_max) / 2;
  const double half_width = radius * std::ceil(((box.x_max - box.x_min) / 2 + margin) / radius);
  const double half_height = row * (std::ceil(((box.y_max - box.y_min) / 2 + margin) / row) + 0.5);
  scene::HexagonalPacking packing;
  packing.set_x_min(middle_x - half_width);
  packing.set_x_max(middle_x + half_width);
  packing.set_y_min(middle_y - half_height);
  packing.set_y_max(middle_y + half_height);
  packing.set_radius(radius);
  return packing;
}

}  // namespace

scene::Particles region_around(const scene::LinedTunnel& tunnel, const Contour& contour,
                               const scene::Continuum& continuum) {
  const scene::TunnelRegion& wanted = tunnel.particles();
  const double outer = tunnel.lining().thickness() + wanted.ground();
  scene::Particles particles;
  *particles.mutable_packing() = packing_over(contour.box(outer), wanted.radius());
  *particles.mutable_within() = tunnel.stage() > 0 ? contour.inside(outer) : contour.between(0, outer);
  particles.set_remove_floaters(true);
  if (wanted.has_material()) *particles.mutable_material() = wanted.material();
  *particles.mutable_bonds() = wanted.bonds();
  // The contact of two groups has the smaller friction: that of the ground must not fall below the lining's
  // unsaid.
  *particles.mutable_contacts() = wanted.contacts();
  if (!wanted.contacts().has_friction())
    particles.mutable_contacts()->set_friction(tunnel.lining().friction());
  *particles.mutable_groups() = wanted.groups();
  *particles.mutable_joints() = wanted.joints();
  if (wanted.has_damping()) *particles.mutable_damping() = wanted.damping();
  for (const auto& load : continuum.body_loads())
    if (!load.has_where()) *particles.add_body_loads() = load;
  if (tunnel.stage() > 0) {
    auto& excavation = *particles.add_excavations();
    *excavation.mutable_where() = contour.inside(tunnel.lining().thickness());
    excavation.set_stage(tunnel.stage());
    if (tunnel.has_released()) excavation.set_released(tunnel.released());
  }
  return particles;
}

}  // namespace adit::coupler
