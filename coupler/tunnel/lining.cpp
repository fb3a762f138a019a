#include "coupler/tunnel/lining.hpp"

#include <string>
#include <vector>

#include "coupler/tunnel/histories.hpp"
#include "coupler/tunnel/joints.hpp"
#include "coupler/tunnel/parts.hpp"

namespace adit::coupler {
namespace {

void add_group(const scene::LinedTunnel& tunnel, const Contour& contour, scene::Particles& particles) {
  const scene::TunnelLining& lining = tunnel.lining();
  std::vector<std::string> ground{"particles"};
  for (const auto& group : particles.groups()) ground.push_back(group.name());
  auto& group = *particles.add_groups();
  group.set_name(tunnel.name());
  *group.mutable_where() = contour.between(0, lining.thickness());
  *group.mutable_material() = lining.material();
  *group.mutable_bonds() = lining.bonds();
  if (!lining.has_bonds() && lining.material().has_mohr_coulomb())
    group.mutable_bonds()->set_strength_of_material(true);
  auto& contacts = *group.mutable_contacts();
  contacts = particles.contacts();
  contacts.clear_normal_stiffness();  // the lining's own, not those of the ground
  contacts.clear_shear_stiffness();
  contacts.set_friction(lining.friction());
  if (tunnel.stage() > 0) group.set_stage(stage_of_lining(tunnel));
  if (tunnel.has_circle() && !group.bonds().has_parallel()) group.set_bends_as_solid(true);
  for (const std::string& other : ground) {
    auto& between = *particles.add_between();
    between.set_first(tunnel.name());
    between.set_second(other);
    if (lining.has_to_ground()) *between.mutable_bonds() = lining.to_ground();
  }
}

// A cut ends a little beyond the faces, so that it meets the bonds between particles on a curved face, and
// evenly, so that its middle is that of the lining.
constexpr double kBeyondFace = 0.05;  // in radii

void add_sections(const scene::LinedTunnel& tunnel, const Contour& contour, scene::Particles& particles) {
  const double beyond = kBeyondFace * tunnel.particles().radius();
  for (std::uint32_t k = 0; k < tunnel.sections(); ++k) {
    const auto cut = contour.cut(static_cast<double>(k) / tunnel.sections());
    auto& section = *particles.add_sections();
    section.set_name(part_name(tunnel, "section", k + 1));
    *section.mutable_from() = point(cut.at(-beyond));
    *section.mutable_to() = point(cut.at(tunnel.lining().thickness() + beyond));
  }
}

// The diameters of a circle.
void add_oval(const scene::LinedTunnel& tunnel, const Contour& contour, scene::Particles& particles) {
  if (!tunnel.has_circle()) return;
  auto& oval = *particles.add_ovals();
  oval.set_name(tunnel.name());
  *oval.mutable_annulus() = contour.between(0, tunnel.lining().thickness()).annulus();
}

}  // namespace

void add_lining(const scene::LinedTunnel& tunnel, const Contour& contour, const std::string& path,
                scene::Particles& particles) {
  add_group(tunnel, contour, particles);
  add_joints(tunnel, contour, path, particles);
  add_sections(tunnel, contour, particles);
  add_oval(tunnel, contour, particles);
  add_convergence(tunnel, contour, particles);
  add_lining_histories(particles);
}

}  // namespace adit::coupler
