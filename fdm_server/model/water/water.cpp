#include "fdm_server/model/water/water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"

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

// By the number of a material.
std::vector<bool> have_pores(const Ground& ground) {
  std::vector<bool> porous(ground.materials.size(), false);
  for (std::size_t m = 0; m < porous.size(); ++m)
    if (ground.materials[m].pores) porous[m] = porous[ground.stated[m]] = true;
  return porous;
}

}  // namespace

void require_water(const scene::Scene& scene, const Grid& grid, const Ground& ground, bool alone) {
  if (!scene.has_water()) return;
  require(!ground.plane_stress, "water", "is computed in plane strain only; write `plane: plane_strain`");
  for (int i = 0; i < scene.water().places_size(); ++i) require_place(scene, i);
  const std::vector<bool> used =
      WaterAtRest(scene.water(), grid, {}, std::numeric_limits<std::uint32_t>::max()).used();
  for (int i = 0; alone && i < scene.water().places_size(); ++i)
    if (!used[static_cast<std::size_t>(i)]) protocol::refuse_empty(path_of_place(i) + ".where", "zones");
  for (int i = 0; i < scene.continuum().materials_size(); ++i)
    require(
        scene.continuum().materials(i).stage() == 0 || !scene.continuum().materials(i).material().has_pores(),
        fmt::format("continuum.materials[{}].stage", i),
        "comes with pores, but what is placed later is dry or tight; leave its pores out, or give stage 0");
  require(ground.any_wet() || !alone, "water",
          fmt::format("reaches no zone of a material with `pores` by its level of y = {:g} m{}; raise the "
                      "level, give the material `pores: {{porosity: 0.4}}`, or leave the water out",
                      scene.water().level(), scene.water().places().empty() ? "" : " and its places"));
}

namespace {

// Water of 20 times the stiffness K of the skeleton takes up 20/21 of a pressure (Skempton's B).
std::optional<std::string> note_on_stiffness(const scene::Water& water, const Ground& ground) {
  constexpr double kEnough = 20, kLittle = 1.5;
  double shortens = 1, enough = 0;
  for (std::size_t z = 0; z < ground.of_zone.size(); ++z) {
    const Material& material = ground.material(z);
    const auto [bulk, shear] = ground.plane_law(z);
    shortens = std::max(shortens, std::sqrt(1 + material.water_stiffness() / (bulk + shear)));
    if (material.water_stiffness() > 0)
      enough = std::max(enough, kEnough * water.bulk_modulus() / material.water_stiffness() *
                                    ground.stiffness_of(z) * material.elasticity().bulk);
  }
  if (shortens < kLittle || enough >= water.bulk_modulus()) return std::nullopt;
  return fmt::format(
      "water.bulk_modulus: P waves are up to {:.2g} times as fast as in drained ground, and the time "
      "step may be as much shorter; {:.2g} MPa would be {:g} times the stiffness of the skeleton times "
      "the porosity, which changes pressures by less than a twentieth",
      shortens, enough / 1e6, kEnough);
}

}  // namespace

std::vector<std::string> notes_on_water(const scene::Scene& scene, const Ground& ground) {
  std::vector<std::string> notes;
  if (!scene.has_water()) return notes;
  if (const auto note = note_on_stiffness(scene.water(), ground)) notes.push_back(*note);
  if (scene.continuum().body_loads().empty())
    notes.emplace_back(
        "water: acts on ground that has no weight, for continuum.body_loads are not given; only what holds "
        "the ground bears the pressure");
  const auto compacts = [](const Material& material) { return material.pores && material.compaction; };
  if (!scene.water().has_bulk_modulus() && std::ranges::any_of(ground.materials, compacts))
    notes.emplace_back(
        "compaction: raises no pressure, because the water has no bulk_modulus; the ground settles as if it "
        "drained at once");
  return notes;
}

void fill_pores(const scene::Scene& scene, const Grid& grid, Ground& ground) {
  if (!scene.has_water()) return;
  std::vector<bool> ever(ground.of_zone.size(), false), at_last = ever;
  for (const std::uint32_t stage : protocol::stages_of(scene)) {
    const auto pressures = WaterAtRest(scene.water(), grid, {}, stage).pressures();
    for (std::size_t z = 0; z < pressures.size(); ++z) {
      at_last[z] = pressures[z] > 0;
      ever[z] = ever[z] || at_last[z];
    }
  }
  const std::size_t count = ground.materials.size();
  std::vector<std::optional<std::uint32_t>> full(count), drained(count);  // by the number of what is stated
  for (std::uint32_t m = 0; m < count; ++m)
    if (ground.materials[m].pores) full[ground.stated[m]] = m;
  const auto add_drained = [&](std::uint32_t wet) {
    Material material = ground.materials[wet];
    material.pores = Pores{};
    ground.materials.push_back(material);
    ground.stated.push_back(ground.stated[wet]);
    return static_cast<std::uint32_t>(ground.materials.size() - 1);
  };
  for (std::size_t z = 0; z < ever.size(); ++z) {
    std::uint32_t& number = ground.of_zone[z];
    if (!ever[z] || !full[number]) continue;
    if (!at_last[z] && !drained[number]) drained[number] = add_drained(*full[number]);
    number = at_last[z] ? *full[number] : *drained[number];
  }
}

std::optional<Flow> resolve_flow(const scene::Scene& scene, const Grid& grid, const Ground& ground,
                                 std::uint32_t stage, std::span<const double> weights,
                                 const SideShares& shares, std::span<const FreeFieldColumn> columns,
                                 std::span<const Lining> linings) {
  const WaterAtRest water(scene.water(), grid, columns, stage);
  std::vector<double> along_x, along_y, stiffness;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const Material& material = ground.material(z);
    const bool flows = material.water_stiffness() > 0 && weights[z] > 0;
    along_x.push_back(flows ? material.pores->permeability_x : 0);
    along_y.push_back(flows ? material.pores->permeability_y : 0);
    stiffness.push_back(material.water_stiffness());
  }
  if (std::ranges::max(along_x) == 0) return std::nullopt;
  std::vector<PointPair> open;
  for (const WetSide& side : sides_under_sea(water, grid, weights, shares))
    if (side.whole) open.push_back(side.points);
  for (const FreeFieldColumn& column : columns)
    if (is_below(grid.y[column.top()], level_on(water, grid, column), grid))
      open.push_back({column.top(), column.top()});
  const std::vector<bool> porous = have_pores(ground);
  for (std::size_t z = 0; z < grid.zones.size(); ++z)  // whose sides may lead into zones with water
    if (weights[z] > 0 && ground.material(z).water_stiffness() == 0 && porous[ground.of_zone[z]])
      for (std::size_t c = 0; c < 4; ++c)
        open.push_back({static_cast<std::uint32_t>(grid.zones[z][c]),
                        static_cast<std::uint32_t>(grid.zones[z][(c + 1) % 4])});
  std::vector<PointPair> sealed;
  for (const Lining& lining : linings)
    for (std::size_t k = 0; k < lining.path.sides(); ++k) sealed.push_back(lining.path.side(k));
  return Flow(grid, make_faces(grid, {along_x, along_y}, open, sealed), stiffness);
}

}  // namespace adit::fdm
