#include "fdm_server/model/water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "fdm_server/grid/edges.hpp"
#include "fdm_server/model/grid/selection.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"
#include "protocol/ground/water_at_rest.hpp"

namespace adit::fdm {
namespace {

using protocol::require;

std::string path_of_place(int i) {
  return fmt::format("water.places[{}]", i);
}

void require_place(const scene::Scene& scene, int i) {
  const scene::WaterPlace& place = scene.water().places(i);
  require(place.has_level() != place.has_pressure(), path_of_place(i),
          "needs either a `level` or a `pressure`; give one of them");
  protocol::require_statics(scene, place.stage(), path_of_place(i));
}

// Sides of one zone that is there.
std::vector<Edge> outer_edges(const Grid& grid, std::span<const double> weights) {
  Grid left{grid.x, grid.y, {}};
  std::vector<std::size_t> numbers;
  for (std::size_t z = 0; z < grid.own_zones(); ++z) {
    if (weights[z] == 0) continue;
    left.zones.push_back(grid.zones[z]);
    numbers.push_back(z);
  }
  std::vector<Edge> edges = boundary(number_edges(left));
  for (Edge& edge : edges) edge.zone = static_cast<std::uint32_t>(numbers[edge.zone]);
  return edges;
}

bool has_ground_above(const Grid& grid, std::span<const double> weights, double x, double y) {
  for (std::size_t z = 0; z < grid.own_zones(); ++z) {
    if (weights[z] == 0) continue;
    const Corners zone = corners(grid, z);
    const auto [left, right] = std::ranges::minmax(zone.x);
    if (left < x && x < right && centroid(zone)[1] > y) return true;
  }
  return false;
}

// By the number of a material.
std::vector<bool> have_pores(const Ground& ground) {
  std::vector<bool> porous(ground.materials.size(), false);
  for (std::size_t m = 0; m < porous.size(); ++m)
    if (ground.materials[m].pores) porous[m] = porous[ground.stated[m]] = true;
  return porous;
}

// Edges up to which the sea reaches, and that nothing but the sea lies above.
std::vector<PointPair> edges_under_sea(const scene::Water& water, const Grid& grid,
                                       std::span<const double> weights) {
  constexpr double kUpwards = 1e-6;     // of the normal
  constexpr double kShared = 1 - 1e-9;  // less than the weight of what no overlap shares, but for rounding
  const double level = water.level() + tolerance(grid);
  std::vector<PointPair> edges;
  for (const auto& [first, second, zone] : outer_edges(grid, weights)) {
    const auto from = static_cast<std::uint32_t>(first), to = static_cast<std::uint32_t>(second);
    const double dx = grid.x[to] - grid.x[from], dy = grid.y[to] - grid.y[from];
    const double x = (grid.x[from] + grid.x[to]) / 2, y = (grid.y[from] + grid.y[to]) / 2;
    if (-dx > kUpwards * std::hypot(dx, dy) && std::max(grid.y[from], grid.y[to]) <= level &&
        !has_ground_above(grid, weights, x, y)) {
      require(
          weights[zone] > kShared, "water",
          fmt::format("stands on the ground at ({:g}, {:g}) m, in an overlap with another model, which would "
                      "not bear it; lower its level, or keep the overlap below the surface",
                      x, y));
      edges.push_back({from, to});
    }
  }
  return edges;
}

}  // namespace

void require_water(const scene::Scene& scene, const Ground& ground, bool alone) {
  if (!scene.has_water()) return;
  require(!ground.plane_stress, "water", "is computed in plane strain only; write `plane: plane_strain`");
  for (int i = 0; i < scene.water().places_size(); ++i) require_place(scene, i);
  for (int i = 0; i < scene.continuum().materials_size(); ++i)
    require(
        scene.continuum().materials(i).stage() == 0 || !scene.continuum().materials(i).material().has_pores(),
        fmt::format("continuum.materials[{}].stage", i),
        "comes with pores, but what is placed later is dry or tight; leave its pores out, or give stage 0");
  require(ground.any_wet() || !alone, "water",
          fmt::format("whose level is y = {:g} m, reaches no zone of a material with `pores`; raise the "
                      "level, give the material `pores: {{porosity: 0.4}}`, or leave the water out",
                      scene.water().level()));
}

// Water of 20 times the stiffness K of the skeleton takes up 20/21 of a pressure (Skempton's B).
std::optional<std::string> note_on_stiffness(const scene::Scene& scene, const Ground& ground) {
  constexpr double kEnough = 20, kLittle = 1.5;
  double shortens = 1, enough = 0;
  for (std::size_t z = 0; z < ground.of_zone.size(); ++z) {
    const Material& material = ground.material(z);
    const auto [bulk, shear] = ground.plane_law(z);
    shortens = std::max(shortens, std::sqrt(1 + material.water_stiffness() / (bulk + shear)));
    if (material.water_stiffness() > 0)
      enough = std::max(enough, kEnough * scene.water().bulk_modulus() / material.water_stiffness() *
                                    ground.stiffness_of(z) * material.elasticity().bulk);
  }
  if (shortens < kLittle || enough >= scene.water().bulk_modulus()) return std::nullopt;
  return fmt::format(
      "water.bulk_modulus: P waves are up to {:.2g} times as fast as in drained ground, and the time step "
      "may be as "
      "much shorter; {:.2g} MPa would be {:g} times the stiffness of the skeleton over the porosity, which "
      "changes "
      "pressures by less than a twentieth",
      shortens, enough / 1e6, kEnough);
}

std::vector<double> pressures_at_rest(const scene::Scene& scene, const Grid& grid, std::uint32_t stage) {
  const scene::Water& water = scene.water();
  std::vector<double> pressures;
  for (std::size_t z = 0; z < grid.zones.size(); ++z)
    pressures.push_back(protocol::pressure_at_rest(water, water.level(), centroid(corners(grid, z))[1]));
  for (int i = 0; i < water.places_size(); ++i) {
    const scene::WaterPlace& place = water.places(i);
    if (place.stage() > stage) continue;
    for (const auto z : zones_in(grid, place.where(), path_of_place(i) + ".where"))
      pressures[z] = place.has_pressure()
                         ? place.pressure()
                         : protocol::pressure_at_rest(water, place.level(), centroid(corners(grid, z))[1]);
  }
  return pressures;
}

void fill_pores(const scene::Scene& scene, const Grid& grid, Ground& ground) {
  if (!scene.has_water()) return;
  std::vector<std::uint32_t> wet_of(ground.materials.size());  // by the number of the dry one
  for (std::uint32_t m = 0; m < wet_of.size(); ++m) wet_of[m] = m;
  for (std::uint32_t m = 0; m < wet_of.size(); ++m)
    if (ground.materials[m].pores) wet_of[ground.stated[m]] = m;
  for (const std::uint32_t stage : protocol::stages_of(scene)) {
    const auto pressures = pressures_at_rest(scene, grid, stage);
    for (std::size_t z = 0; z < pressures.size(); ++z)
      if (pressures[z] > 0) ground.of_zone[z] = wet_of[ground.of_zone[z]];
  }
}

Load weight_of_sea(const scene::Water& water, const Grid& grid, std::span<const double> weights,
                   std::span<const FreeFieldColumn> columns) {
  Load load;
  const auto pressure = [&](std::uint32_t point) {
    return protocol::pressure_at_rest(water, water.level(), grid.y[point]);
  };
  const auto add = [&load](std::uint32_t point, double fx, double fy) {
    load.points.push_back(point);
    load.fx.push_back(fx);
    load.fy.push_back(fy);
  };
  for (const auto& [from, to] : edges_under_sea(water, grid, weights)) {
    const double dx = grid.x[to] - grid.x[from], dy = grid.y[to] - grid.y[from];  // the normal is (dy, -dx)
    // The ends' shares of a pressure that is linear between them.
    for (const auto& [point, other] : {std::pair{from, to}, {to, from}}) {
      const double share = (2 * pressure(point) + pressure(other)) / 6;
      add(point, -share * dy, share * dx);
    }
  }
  for (const FreeFieldColumn& column : columns) add(column.top(), 0, -pressure(column.top()) * column.width);
  return load;
}

std::optional<Flow> resolve_flow(const scene::Water& water, const Grid& grid, const Ground& ground,
                                 std::span<const double> weights, std::span<const FreeFieldColumn> columns,
                                 std::span<const Lining> linings) {
  std::vector<double> along_x, along_y, stiffness;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const Material& material = ground.material(z);
    const bool flows = material.pores && material.pores->stiffness > 0 && weights[z] > 0;
    along_x.push_back(flows ? material.pores->permeability_x : 0);
    along_y.push_back(flows ? material.pores->permeability_y : 0);
    stiffness.push_back(material.water_stiffness());
  }
  if (std::ranges::max(along_x) == 0) return std::nullopt;
  std::vector<PointPair> open = edges_under_sea(water, grid, weights);
  for (const FreeFieldColumn& column : columns)
    if (grid.y[column.top()] <= water.level()) open.push_back({column.top(), column.top()});
  const std::vector<bool> porous = have_pores(ground);
  for (std::size_t z = 0; z < grid.zones.size(); ++z)  // whose sides may lead into wet zones
    if (weights[z] > 0 && !ground.wet(z) && porous[ground.of_zone[z]])
      for (std::size_t c = 0; c < 4; ++c)
        open.push_back({static_cast<std::uint32_t>(grid.zones[z][c]),
                        static_cast<std::uint32_t>(grid.zones[z][(c + 1) % 4])});
  std::vector<PointPair> sealed;
  for (const Lining& lining : linings)
    for (std::size_t k = 0; k < lining.path.sides(); ++k) sealed.push_back(lining.path.side(k));
  return Flow(grid, make_faces(grid, {along_x, along_y}, open, sealed), stiffness);
}

}  // namespace adit::fdm
