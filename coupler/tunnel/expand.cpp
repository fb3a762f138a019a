#include "coupler/tunnel/expand.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupler/tunnel/contour.hpp"
#include "coupler/tunnel/grid_tunnels.hpp"
#include "coupler/tunnel/layers.hpp"
#include "coupler/tunnel/lining.hpp"
#include "coupler/tunnel/parts.hpp"
#include "coupler/tunnel/region.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

// Of a lattice over the thickness, below which it bends noticeably softer than the solid (docs/particles.md).
struct FewRows {
  double rows;
  const char* softer;
};
constexpr FewRows kStraight{5, "by 12 % with 5 rows and 22 % with 3 (nu = 0.2)"};
constexpr FewRows kRing{7, "by 11 % with 5 rows and 31 % with 3 (nu = 0.2)"};

void add_note_on_rows(const scene::LinedTunnel& tunnel, std::vector<std::string>& notes) {
  if (of_cells(tunnel)) return;
  const double thickness = tunnel.lining().thickness();
  const double rows = std::floor(thickness / (std::numbers::sqrt3 * tunnel.particles().radius()) + 1e-6);
  const auto& [few, softer] = tunnel.has_circle() ? kRing : kStraight;
  if (rows >= few) return;
  notes.push_back(fmt::format(
      "{}: {:g} row{} of particles lie over the lining's thickness; the fewer they are, the softer it is in "
      "bending than the solid, {}; a radius of {:.3g} m or less gives {:g}",
      tunnel.name(), rows, rows == 1 ? "" : "s", softer, thickness / (few * std::numbers::sqrt3), few));
}

void add_note_on_elastic_ground(const scene::LinedTunnel& tunnel, const std::vector<std::string>& zones,
                                std::vector<std::string>& notes) {
  if (zones.empty()) return;
  notes.push_back(fmt::format(
      "{}: the particles around it are elastic where {} has a law beyond elasticity; give the tunnel a "
      "`particles.material`{}",
      tunnel.name(), fmt::join(zones, ", "),
      of_cells(tunnel)
          ? " with `fracture`"
          : ", or set `particles.bonds.strength_of_material` for a strength by Mohr and Coulomb"));
}

scene::Interface interface_around(const scene::LinedTunnel& tunnel, const Contour& contour) {
  scene::Interface interface;
  const double width = tunnel.particles().overlap();
  *interface.mutable_overlap()->mutable_around() =
      contour.shape(tunnel.lining().thickness() + tunnel.particles().ground() - width);
  interface.mutable_overlap()->set_width(width);
  interface.set_solve(scene::SPLIT);
  return interface;
}

// The particles' path in the expanded scene.
std::string add_as_particles(const scene::Particles& particles, const scene::Interface& interface,
                             const std::string& path, Expansion& expansion) {
  *expansion.scene.mutable_particles() = particles;
  *expansion.scene.mutable_interface() = interface;
  expansion.origins = {{"particles", path}, {"interface", path}};
  return "particles";
}

std::string add_as_region(const std::string& name, const scene::Particles& particles,
                          scene::Interface interface, const std::string& path, Expansion& expansion) {
  const std::string region_path = fmt::format("regions[{}]", expansion.scene.regions_size());
  expansion.origins.push_back({region_path, path});
  expansion.origins.push_back({fmt::format("interfaces[{}]", expansion.scene.interfaces_size()), path});
  auto& region = *expansion.scene.add_regions();
  region.set_name(name);
  *region.mutable_particles() = particles;
  interface.set_inner(name);
  *expansion.scene.add_interfaces() = interface;
  return region_path + ".particles";
}

bool is_of_particles(const scene::LinedTunnel& tunnel) {
  return tunnel.lining().as() == scene::TunnelLining::PARTICLES;
}

void require_grains(const scene::LinedTunnel& tunnel, const std::string& path) {
  if (tunnel.particles().has_size() == tunnel.particles().has_radius())
    throw UserError(path + ".particles",
                    fmt::format("{}; give `size` for cells or `radius` for a lattice of discs",
                                of_cells(tunnel) ? "has size and radius" : "needs size or radius"));
  if (const double most = tunnel.lining().thickness() / 2;
      of_cells(tunnel) && tunnel.particles().size() > most)
    throw UserError(path + ".particles.size",
                    fmt::format("is {} m, more than half of the lining's thickness; give at most {:.4g} m",
                                tunnel.particles().size(), most));
  if (!of_cells(tunnel) && tunnel.particles().has_ground_size())
    throw UserError(path + ".particles.ground_size", "is of cells, but `radius` asks for discs; give `size`");
}

// With what its section states.
scene::LinedTunnel with_section_read(scene::LinedTunnel tunnel, const std::string& path) {
  const LiningLayer layer = layers_of(tunnel, path).front();
  tunnel.mutable_lining()->set_thickness(layer.thickness);
  *tunnel.mutable_lining()->mutable_material() = layer.material;
  return tunnel;
}

// `alone`: whether they become the `particles` of the scene.
void add_particles(const scene::LinedTunnel& given, const std::string& path,
                   const scene::Continuum& continuum, bool alone, Expansion& expansion) {
  const scene::LinedTunnel tunnel = with_section_read(given, path);
  require_grains(tunnel, path);
  const Contour contour(tunnel, path);
  TunnelGround ground = ground_around(tunnel, contour, continuum);
  add_lining(tunnel, contour, path, ground.particles);
  const scene::Interface interface = interface_around(tunnel, contour);
  const std::string part = alone ? add_as_particles(ground.particles, interface, path, expansion)
                                 : add_as_region(tunnel.name(), ground.particles, interface, path, expansion);
  for (std::size_t group = 0; group < ground.zones.size(); ++group)
    expansion.origins.insert(expansion.origins.begin(),
                             {fmt::format("{}.groups[{}]", part, group), path,
                              fmt::format("continuum.materials[{}]", ground.zones[group])});
  add_note_on_rows(tunnel, expansion.notes);
  add_note_on_elastic_ground(tunnel, ground.elastic, expansion.notes);
}

// Zones and particles of a lining lie in the field of the ground, but are no ground.
void require_beams(const scene::LinedTunnel& tunnel, const std::string& path) {
  if (tunnel.lining().as() != scene::TunnelLining::BEAM)
    throw UserError(
        path + ".lining.as",
        "is not beam, but `continuum.scatter` would scatter the zones or particles of the lining as the "
        "ground; write `as: beam`, or leave `scatter` out");
}

}  // namespace

Expansion expand_tunnels(const scene::Scene& given) {
  Expansion expansion{given, {}, {}};
  if (given.tunnels().empty()) return expansion;
  expansion.scene.clear_tunnels();
  if (!given.has_continuum())
    throw UserError("tunnels", "lie in no ground; give the scene a `continuum` around them");
  if (!given.continuum().scatter().empty())
    for (int k = 0; k < given.tunnels_size(); ++k)
      require_beams(given.tunnels(k), fmt::format("tunnels[{}]", k));
  const auto of_particles = std::ranges::count_if(given.tunnels(), is_of_particles);
  const bool alone = of_particles == 1 && !given.has_particles() && !given.has_interface();
  for (int k = 0; k < given.tunnels_size(); ++k)
    if (is_of_particles(given.tunnels(k)))
      add_particles(given.tunnels(k), fmt::format("tunnels[{}]", k), given.continuum(), alone, expansion);
  add_grid_tunnels(given, expansion);
  return expansion;
}

UserError Expansion::at_tunnel(const UserError& error) const {
  for (const auto& [part, tunnel, zones] : origins)
    if (error.path() == part || error.path().starts_with(part + "."))
      return zones.empty()
                 ? UserError(tunnel, fmt::format("becomes `{}`, which {}", error.path(), error.what()))
                 : UserError(zones, fmt::format("becomes `{}` in `{}`, which {}; or state the ground by "
                                                "`particles.material` of the tunnel",
                                                error.path(), tunnel, error.what()));
  return error;
}

}  // namespace adit::coupler
