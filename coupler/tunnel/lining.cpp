#include "coupler/tunnel/lining.hpp"

#include <string>
#include <utility>
#include <vector>

#include "coupler/tunnel/bars.hpp"
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
  if (!of_cells(tunnel) && !lining.has_bonds() && lining.material().has_mohr_coulomb())
    group.mutable_bonds()->set_strength_of_material(true);
  auto& contacts = *group.mutable_contacts();
  contacts = particles.contacts();
  contacts.clear_normal_stiffness();  // the lining's own, not those of the ground
  contacts.clear_shear_stiffness();
  contacts.set_friction(lining.friction());
  if (tunnel.stage() > 0) group.set_stage(stage_of_lining(tunnel));
  if (!of_cells(tunnel) && tunnel.has_circle() && !group.bonds().has_parallel())
    group.set_bends_as_solid(true);
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
  const double beyond = kBeyondFace * grain_radius(tunnel);
  for (std::uint32_t k = 0; k < tunnel.sections(); ++k) {
    const auto cut = contour.cut(static_cast<double>(k) / tunnel.sections());
    auto& section = *particles.add_sections();
    section.set_name(part_name(tunnel, "section", k + 1));
    *section.mutable_from() = point(cut.at(-beyond));
    *section.mutable_to() = point(cut.at(tunnel.lining().thickness() + beyond));
    if (tunnel.lining().has_section()) *section.mutable_section() = tunnel.lining().section();
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
  add_bars(tunnel, contour, path, particles);
  add_sections(tunnel, contour, particles);
  add_oval(tunnel, contour, particles);
  add_convergence(tunnel, contour, particles);
  add_lining_histories(particles);
  if (of_cells(tunnel) &&
      (tunnel.lining().material().has_fracture() || tunnel.lining().bonds().has_fracture()))
    add_history(particles, tunnel.name(), scene::CRACK_WIDTH).set_group(tunnel.name());
}

std::array<std::pair<const char*, geometry::Point>, 4> convergence_places(const Contour& contour,
                                                                          double offset) {
  const auto box = contour.box(offset);
  const auto [x, y] = contour.centre();
  return {{{"crown", {x, box.y_max}},
           {"invert", {x, box.y_min}},
           {"left", {box.x_min, y}},
           {"right", {box.x_max, y}}}};
}

// The particle on the inner side has its centre a radius or so outside it.
void add_convergence(const scene::LinedTunnel& tunnel, const Contour& contour, scene::Particles& particles) {
  for (const auto& [part, place] : convergence_places(contour, grain_radius(tunnel)))
    for (const scene::Quantity quantity : {scene::DISPLACEMENT_X, scene::DISPLACEMENT_Y})
      *add_history(particles, tunnel.name() + "_" + part, quantity).mutable_at() = point(place);
}

void add_lining_histories(scene::Particles& particles) {
  for (const auto& joint : particles.joints())
    if (joint.has_name())
      for (const scene::Quantity quantity : {scene::OPENING, scene::OFFSET, scene::ROTATION})
        add_history(particles, joint.name(), quantity).set_joint(joint.name());
  for (const auto& spring : particles.springs())
    if (spring.has_name())
      add_history(particles, spring.name(), scene::SPRING_FORCE).set_spring(spring.name());
  for (const auto& oval : particles.ovals())
    for (const scene::Quantity quantity :
         {scene::LARGEST_DIAMETER_CHANGE, scene::SMALLEST_DIAMETER_CHANGE, scene::LARGEST_DIAMETER_DIRECTION})
      add_history(particles, oval.name(), quantity).set_oval(oval.name());
  for (const auto& section : particles.sections())
    for (const scene::Quantity quantity : quantities_of_sections(section.has_section()))
      add_history(particles, section.name(), quantity).set_section(section.name());
}

}  // namespace adit::coupler
