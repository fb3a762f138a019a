#include "coupler/tunnel/region.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "coupler/ground/stated_ground.hpp"
#include "coupler/tunnel/parts.hpp"
#include "protocol/errors.hpp"
#include "protocol/geometry/selection.hpp"

namespace adit::coupler {
namespace {

// The next whole number. Where the sizes are whole already, rounding must not add one, by which the lattice
// would lie elsewhere as the tunnel does.
double at_least(double number) {
  return std::ceil(number - 1e-6);
}

// The packing lies in the middle of its box. An odd number of rows puts a whole one at half the height, so
// that the lattice is symmetric about both axes of the box.
scene::HexagonalPacking packing_over(const geometry::BoundingBox& box, double radius) {
  const double margin = 2 * radius, row = std::numbers::sqrt3 * radius;
  const double middle_x = (box.x_min + box.x_max) / 2, middle_y = (box.y_min + box.y_max) / 2;
  const double half_width = radius * at_least(((box.x_max - box.x_min) / 2 + margin) / radius);
  const double half_height = row * (at_least(((box.y_max - box.y_min) / 2 + margin) / row) + 0.5);
  scene::HexagonalPacking packing;
  packing.set_x_min(middle_x - half_width);
  packing.set_x_max(middle_x + half_width);
  packing.set_y_min(middle_y - half_height);
  packing.set_y_max(middle_y + half_height);
  packing.set_radius(radius);
  return packing;
}

// The cells end at the outline of `within`, some way inside the box.
scene::CellPacking cells_over(const geometry::BoundingBox& box, const scene::Area& lining,
                              const scene::TunnelRegion& wanted) {
  const double size = wanted.has_ground_size() ? wanted.ground_size() : wanted.size(), margin = 2 * size;
  scene::CellPacking cells;
  cells.set_x_min(box.x_min - margin);
  cells.set_x_max(box.x_max + margin);
  cells.set_y_min(box.y_min - margin);
  cells.set_y_max(box.y_max + margin);
  cells.set_size(size);
  if (size > wanted.size()) {
    scene::FinerCells& finer = *cells.add_finer();
    *finer.mutable_where() = lining;
    finer.set_size(wanted.size());
  }
  if (wanted.has_seed()) cells.set_seed(wanted.seed());
  return cells;
}

constexpr double kMostPlaces = 2000;  // along a side, whatever radius a scene states

// Places inside an area that are so far from its boundary that a disc of the lattice has its centre around
// them.
std::vector<geometry::Point> places_inside(const scene::Area& area, const geometry::BoundingBox& box,
                                           double radius) {
  const protocol::Places inside(area, "tunnels", -kNearestCentre * radius);
  const double side = std::max(box.x_max - box.x_min, box.y_max - box.y_min);
  const double step = std::max(radius / 2, side / kMostPlaces);
  std::vector<geometry::Point> places;
  for (double y = box.y_min; y <= box.y_max; y += step)
    for (double x = box.x_min; x <= box.x_max; x += step)
      if (inside.hold(x, y)) places.push_back({x, y});
  return places;
}

// What bonds can stand for of the zones' material at this path: elastic, or a strength that they take from
// it; cells also break as it states.
scene::Material as_bonds_have_it(scene::Material material, const scene::Bonds& bonds, bool cells,
                                 const std::string& path, std::vector<std::string>& elastic) {
  const bool strength = material.has_mohr_coulomb() && !bonds.strength_of_material();
  if (!cells) material.clear_fracture();
  if ((strength && !material.has_fracture()) || material.has_hysteretic() || material.has_weak_plane() ||
      material.has_pm4sand() || material.pores().has_compaction())
    elastic.push_back(path);
  material.clear_hysteretic();
  material.clear_weak_plane();
  material.clear_pm4sand();
  if (strength) material.clear_mohr_coulomb();
  return material;
}

// The ground of the zones that the particles replace: groups for other materials that reach into it.
void take_over_materials(const scene::LinedTunnel& tunnel, const Contour& contour,
                         const scene::Continuum& continuum, TunnelGround& taken) {
  scene::Particles& particles = taken.particles;
  const scene::Bonds& bonds = particles.bonds();
  if (continuum.has_material())
    *particles.mutable_material() =
        as_bonds_have_it(continuum.material(), bonds, of_cells(tunnel), "continuum.material", taken.elastic);
  if (continuum.materials().empty()) return;
  const double lining = tunnel.lining().thickness(), outer = lining + tunnel.particles().ground();
  const double radius = grain_radius(tunnel);
  const auto ground =
      places_inside(tunnel.stage() > 0 ? contour.inside(outer) : contour.between(lining, outer),
                    contour.box(outer), radius);
  for (int k = 0; k < continuum.materials_size(); ++k) {
    const scene::MaterialArea& zones = continuum.materials(k);
    const std::string path = fmt::format("continuum.materials[{}]", k);
    for (const auto& area : by_place(zones.where(), continuum).value_or(std::vector<scene::Area>{})) {
      const protocol::Places inside(area, path + ".where", -kNearestCentre * radius);
      if (std::ranges::none_of(ground, [&](const auto& place) { return inside.hold(place.x, place.y); }))
        continue;
      protocol::require(
          zones.stage() == 0, path + ".stage",
          fmt::format("is {}, but the area reaches into the particles of tunnel `{}`, which keep "
                      "their material; keep it out of them, or give stage 0",
                      zones.stage(), tunnel.name()));
      auto& group = *particles.add_groups();
      group.set_name(part_name(tunnel, "ground", static_cast<std::size_t>(particles.groups_size())));
      *group.mutable_where() = area;
      *group.mutable_material() =
          as_bonds_have_it(zones.material(), bonds, of_cells(tunnel), path, taken.elastic);
      taken.zones.push_back(k);
    }
  }
}

}  // namespace

TunnelGround ground_around(const scene::LinedTunnel& tunnel, const Contour& contour,
                           const scene::Continuum& continuum) {
  const scene::TunnelRegion& wanted = tunnel.particles();
  const double outer = tunnel.lining().thickness() + wanted.ground();
  TunnelGround ground;
  scene::Particles& particles = ground.particles;
  if (of_cells(tunnel))
    *particles.mutable_cells() =
        cells_over(contour.box(outer), contour.between(0, tunnel.lining().thickness()), wanted);
  else
    *particles.mutable_packing() = packing_over(contour.box(outer), wanted.radius());
  *particles.mutable_within() = tunnel.stage() > 0 ? contour.inside(outer) : contour.between(0, outer);
  if (!of_cells(tunnel)) particles.set_remove_floaters(true);
  if (wanted.has_material()) *particles.mutable_material() = wanted.material();
  *particles.mutable_bonds() = wanted.bonds();
  // The contact of two groups has the smaller friction: that of the ground must not fall below the lining's
  // unsaid.
  *particles.mutable_contacts() = wanted.contacts();
  if (!wanted.contacts().has_friction())
    particles.mutable_contacts()->set_friction(tunnel.lining().friction());
  if (!wanted.has_material()) take_over_materials(tunnel, contour, continuum, ground);
  particles.mutable_groups()->MergeFrom(wanted.groups());
  *particles.mutable_joints() = wanted.joints();
  if (wanted.has_damping()) *particles.mutable_damping() = wanted.damping();
  if (wanted.has_begin()) *particles.mutable_begin() = wanted.begin();
  for (const auto& load : continuum.body_loads())
    if (!load.has_where()) *particles.add_body_loads() = load;
  if (tunnel.stage() > 0) {
    auto& excavation = *particles.add_excavations();
    *excavation.mutable_where() = contour.inside(tunnel.lining().thickness());
    excavation.set_stage(tunnel.stage());
    if (tunnel.has_released()) excavation.set_released(tunnel.released());
  }
  return ground;
}

}  // namespace adit::coupler
