#include "dem_server/model/solid/wet_ground.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dem_server/model/placement/groups.hpp"
#include "dem_server/model/solid/facets_of_material.hpp"
#include "protocol/errors.hpp"
#include "protocol/geometry/selection.hpp"
#include "protocol/ground/water_at_rest.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

void fill(const scene::Water& water, const std::string& path, scene::Material& material,
          std::vector<std::string>& notes) {
  const scene::Pores& pores = material.pores();
  if (pores.has_saturated_density()) material.set_density(pores.saturated_density());
  if (!water.has_bulk_modulus()) return;
  const double nu = material.poisson_ratio(), shear = material.young_modulus() / (2 * (1 + nu));
  const auto bulk_for = [shear](double ratio) { return shear * 2 * (1 + ratio) / (3 * (1 - 2 * ratio)); };
  const double most = bulk_for(kLargestPoissonRatio) - bulk_for(nu);
  const double wanted = water.bulk_modulus() / pores.porosity(), taken = std::clamp(most, 0.0, wanted);
  if (taken < wanted)
    notes.push_back(
        fmt::format("{}.pores: cells take water of at most {:.3g} MPa, by their largest Poisson's ratio of "
                    "{}; {:.3g} MPa "
                    "are stated",
                    path, taken * pores.porosity() / 1e6, kLargestPoissonRatio, water.bulk_modulus() / 1e6));
  const double bulk = bulk_for(nu) + taken;
  const double undrained = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
  material.set_poisson_ratio(std::min(undrained, kLargestPoissonRatio));
  material.set_young_modulus(2 * shear * (1 + material.poisson_ratio()));
}

bool any_pores(const scene::Scene& scene) {
  return material_of(scene).has_pores() ||
         std::ranges::any_of(scene.particles().groups(),
                             [](const auto& group) { return group.material().has_pores(); });
}

}  // namespace

std::vector<std::string> fill_pores(scene::Scene& scene) {
  std::vector<std::string> notes;
  if (!scene.has_water()) return notes;
  scene::Particles& particles = *scene.mutable_particles();
  const auto take = [&](scene::Material& material, const std::string& path) {
    if (!material.has_pores()) return;
    if (!particles.has_cells())
      throw UserError(
          path + ".pores",
          "are given beside water, but discs are not as incompressible as wet ground; pack `cells`, "
          "or leave the pores out and state the constants of the ground with its water");
    if (scene.plane() == scene::PLANE_STRESS)
      throw UserError("water", "is computed in plane strain only; write `plane: plane_strain`");
    fill(scene.water(), path, material, notes);
  };
  if (particles.has_material())
    take(*particles.mutable_material(), "particles.material");
  else if (scene.has_material())
    take(*scene.mutable_material(), "material");
  for (int k = 0; k < particles.groups_size(); ++k)
    if (particles.groups(k).has_material())
      take(*particles.mutable_groups(k)->mutable_material(), fmt::format("particles.groups[{}].material", k));
  return notes;
}

void require_in_water(const scene::Scene& scene, const Model& model) {
  if (!scene.has_water() || !any_pores(scene)) return;
  const std::vector<Group> groups = read_groups(scene);
  const scene::Water& water = scene.water();
  for (int k = 0; k < water.places_size(); ++k) {
    const auto path = fmt::format("water.places[{}]", k);
    if (water.places(k).where().has_group()) continue;  // which is of zones
    const protocol::Places inside(water.places(k).where(), path + ".where", 0);
    for (std::size_t i = 0; i < model.discs.size(); ++i)
      if (groups[model.group[i]].material.material.has_pores() &&
          inside.hold(model.discs.x[i], model.discs.y[i]))
        throw UserError(
            path + ".where",
            fmt::format("holds the particle at ({:.4g}, {:.4g}) m, but particles have one level of "
                        "water; keep the place out of them",
                        model.discs.x[i], model.discs.y[i]));
  }
  for (std::size_t i = 0; i < model.discs.size(); ++i) {
    const MaterialAt& at = groups[model.group[i]].material;
    if (at.material.has_pores() && model.discs.y[i] > water.level())
      throw UserError(
          at.path + ".pores",
          fmt::format("are those of the particle at ({:.4g}, {:.4g}) m, which lies above the water; "
                      "give the particles there a group of dry ground, without pores",
                      model.discs.x[i], model.discs.y[i]));
  }
}

StressAt stated_stress(const scene::Scene& scene) {
  const protocol::StatedStress stated(scene);
  if (!scene.has_water() || !any_pores(scene))
    return [stated](double x, double y) { return stated.at(x, y); };
  return [stated, water = scene.water()](double x, double y) {
    return stated.at(x, y, protocol::pressure_at_rest(water, water.level(), y));
  };
}

}  // namespace adit::dem
