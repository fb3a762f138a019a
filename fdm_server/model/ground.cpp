#include "fdm_server/model/ground.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "fdm_server/model/grid/selection.hpp"
#include "fdm_server/zones/laws/cyclic_driver.hpp"
#include "fdm_server/zones/laws/pm4sand_calibration.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stated_stress.hpp"
#include "protocol/materials/fracture.hpp"
#include "protocol/scatter/scattering.hpp"

namespace adit::fdm {
namespace {

using protocol::require;

// A row of strengths, or a weak plane; what the scene leaves out is as in `before`.
template <class Scene>
Strength read_strength(const Scene& scene, const Strength& before, const std::string& path) {
  Strength strength = before;
  if (scene.has_cohesion()) strength.cohesion = scene.cohesion();
  if (scene.has_friction_angle()) strength.friction_angle = scene.friction_angle();
  if (scene.has_dilation_angle()) strength.dilation_angle = scene.dilation_angle();
  require(strength.dilation_angle <= strength.friction_angle, path + ".dilation_angle",
          fmt::format("is {} rad, more than the friction angle of {} rad: the ground would gain energy by "
                      "failing; give at most that",
                      strength.dilation_angle, strength.friction_angle));
  const double most = apex(strength.cohesion, strength.friction_angle);
  require(!scene.has_tension() || scene.tension() <= most, path + ".tension",
          fmt::format("is {} Pa, but must be at most cohesion / tan(friction_angle) = {} Pa", scene.tension(),
                      most));
  strength.tension = std::min(scene.has_tension() ? scene.tension() : before.tension, most);
  return strength;
}

const scene::Material& material_of(const scene::Scene& scene, std::size_t number) {
  const scene::Continuum& continuum = scene.continuum();
  if (number > 0) return continuum.materials(static_cast<int>(number) - 1).material();
  return continuum.has_material() ? continuum.material() : scene.material();
}

std::string path_of_material(const scene::Scene& scene, std::size_t number) {
  if (number > 0) return fmt::format("continuum.materials[{}].material", number - 1);
  return scene.continuum().has_material() ? "continuum.material" : "material";
}

constexpr Strength kNoStrength{0, 0, 0, HUGE_VAL};

// Einav and Randolph (2005), Int. J. Numer. Meth. Eng. 63, eq. 3. Chords of the curve in so many rows are at
// most 0.5 percent of what is lost off it, and of that exp(-6) is left after the last.
void remould(const scene::MohrCoulomb& scene, const std::string& path, std::vector<SofteningRow>& rows) {
  constexpr int kRows = 32;
  require(scene.softening().empty(), path + ".remoulding",
          "is given beside `softening`, which says the same; leave one of them out");
  require(scene.friction_angle() == 0, path + ".remoulding",
          "is of clay without drainage, whose strength is its cohesion alone; leave `friction_angle` out, or "
          "give `softening` in place of it");
  const double sensitivity = scene.remoulding().sensitivity(), strain_95 = scene.remoulding().strain_95();
  for (int i = 1; i <= kRows; ++i) {
    SofteningRow row{2 * strain_95 * i / kRows, rows.front().strength};
    const double kept = 1 / sensitivity + (1 - 1 / sensitivity) * std::exp(-3 * row.strain / strain_95);
    row.strength.cohesion *= kept;
    row.strength.tension *= kept;
    rows.push_back(row);
  }
}

MohrCoulomb read_mohr_coulomb(const scene::MohrCoulomb& scene, const std::string& path) {
  std::vector<SofteningRow> rows{{0, read_strength(scene, kNoStrength, path)}};
  for (int i = 0; i < scene.softening_size(); ++i) {
    const auto row = fmt::format("{}.softening[{}]", path, i);
    const double strain = scene.softening(i).plastic_shear_strain();
    require(strain > rows.back().strain, row + ".plastic_shear_strain",
            fmt::format("is {}, but must be larger than {} before it", strain, rows.back().strain));
    rows.push_back({strain, read_strength(scene.softening(i), rows.back().strength, row)});
  }
  if (scene.has_remoulding()) remould(scene, path, rows);
  return MohrCoulomb(std::move(rows));
}

ModulusReduction read_table(const scene::ReductionTable& table, const std::string& path) {
  const auto &strains = table.shear_strain(), &ratios = table.ratio();
  for (int i = 1; i < strains.size(); ++i) {
    require(ratios[i] <= ratios[i - 1], path + ".ratio",
            fmt::format("rises at its value {}: {}; G/Gmax falls with the strain", i + 1, ratios[i]));
    require(
        strains[i] * ratios[i] >= strains[i - 1] * ratios[i - 1], path + ".ratio",
        fmt::format("falls so fast at the strain {} that the shear stress falls too; this law cannot soften: "
                    "leave the points from there on out, and the stress stays constant beyond the last",
                    strains[i]));
  }
  require(ratios[0] == 1, path + ".ratio",
          fmt::format(
              "begins with {}; give a small strain where it is 1, the modulus being young_modulus / (2 (1 + "
              "poisson_ratio))",
              ratios[0]));
  return smooth_table({strains.data(), static_cast<std::size_t>(strains.size())},
                      {ratios.data(), static_cast<std::size_t>(ratios.size())});
}

// A curve, and the backbone that follows it.
struct Curve {
  ModulusReduction reduction;
  std::vector<BackbonePoint> backbone;
};
Curve read_curve(const scene::Hysteretic& scene, const std::string& path) {
  const auto elements = scene.elements();
  if (scene.has_table()) {
    const auto& strains = scene.table().shear_strain();
    const auto reduction = read_table(scene.table(), path + ".table");
    return {reduction, backbone(reduction, strains[0], strains[strains.size() - 1], elements)};
  }
  require(scene.has_hyperbola(), path, "names no curve; give table or hyperbola");
  const double reference = scene.hyperbola().reference_strain(), exponent = scene.hyperbola().exponent();
  // below, the modulus is reduced by less than the hundredth part at which loops are noticed; above, the
  // stress stays
  const double first = reference * std::pow(2e-3, 1 / exponent);
  const auto reduction = hyperbola(reference, exponent);
  return {reduction, backbone(reduction, first, 10 * reference, elements)};
}

// The share of Masing's damping that loops keep.
std::function<double(double)> read_share(const scene::LoopDamping& scene, const Curve& curve,
                                         const Polyline& backbone, const std::string& path) {
  require(scene.has_table() || scene.has_darendeli(), path, "names no curve; give table or darendeli");
  if (scene.has_darendeli()) return darendeli_share(curve.reduction, scene.darendeli().cycles());
  const auto &strains = scene.table().shear_strain(), &ratios = scene.table().ratio();
  const auto count = static_cast<std::size_t>(strains.size());
  return [&backbone, damping = smooth_table({strains.data(), count}, {ratios.data(), count})](double strain) {
    return std::min(1.0, damping(strain) / backbone.masing_damping(strain));
  };
}

void read_hysteretic(const scene::Hysteretic& scene, const std::string& path, Material& material) {
  Curve curve = read_curve(scene, path);
  if (scene.memory() == scene::Hysteretic::ELEMENTS) {
    require(!scene.has_damping(), path + ".damping",
            "needs `memory: reversals`; elements dissipate by Masing's rules");
    material.hysteretic = iwan_elements(curve.backbone);
    return;
  }
  Polyline backbone(curve.backbone);
  if (scene.has_damping())
    backbone.narrow(read_share(scene.damping(), curve, backbone, path + ".damping"), path + ".damping");
  material.reversals = std::move(backbone);
}

YieldCone read_fracture(const scene::Fracture& scene, const std::string& path) {
  return MohrCoulomb(
             {protocol::cohesion_of(scene, path), scene.friction_angle(), 0, scene.tensile_strength()})
      .cone(0);
}

// h_po of the sand, which has the other parameters.
double read_contraction_rate(const scene::Pm4Sand& scene, const Pm4Sand& sand, const std::string& path) {
  require(scene.contraction_case() != scene::Pm4Sand::CONTRACTION_NOT_SET, path,
          "states no resistance; give `cyclic_resistance`, or `contraction_rate`");
  if (scene.has_contraction_rate()) return scene.contraction_rate();
  const auto found = contraction_rate(sand, scene.cyclic_resistance());
  if (found) return *found;
  // By a hundredth inside, so that the figures may be given as they are told.
  const double least = 1.01 * cyclic_resistance(sand, kLeastContractionRate),
               most = 0.99 * cyclic_resistance(sand, kMostContractionRate);
  throw protocol::UserError(
      path + ".cyclic_resistance",
      fmt::format("is {:g}, but with relative_density {:g} and modulus_coefficient {:.4g} only {:.3g} to "
                  "{:.3g} can be reached; give one of these, or another density",
                  scene.cyclic_resistance(), sand.relative_density, sand.modulus_coefficient, least, most));
}

Pm4Sand read_pm4sand(const scene::Material& scene, const std::string& path) {
  const char* beside = scene.has_mohr_coulomb()         ? "mohr_coulomb"
                       : scene.has_hysteretic()         ? "hysteretic"
                       : scene.has_weak_plane()         ? "weak_plane"
                       : scene.has_fracture()           ? "fracture"
                       : scene.pores().has_compaction() ? "pores.compaction"
                                                        : nullptr;
  require(
      !beside, path + ".pm4sand",
      fmt::format("is given beside {}, but has a strength and a compaction of its own; leave one of them out",
                  beside ? beside : ""));
  const scene::Pm4Sand& stated = scene.pm4sand();
  const double density = stated.relative_density();
  Pm4Sand sand{density,
               stated.has_modulus_coefficient() ? stated.modulus_coefficient() : modulus_coefficient(density),
               0, stated.largest_pressure()};
  sand.contraction_rate = read_contraction_rate(stated, sand, path + ".pm4sand");
  if (stated.has_reconsolidation_from()) sand.reconsolidation_from = stated.reconsolidation_from();
  return sand;
}

Compaction read_compaction(const scene::Compaction& scene, const Material& material,
                           const std::string& path) {
  require(scene.resistance_case() != scene::Compaction::RESISTANCE_NOT_SET, path,
          "states no resistance; give `cyclic_resistance`, or `blow_count`");
  require(material.mohr_coulomb.has_value(), path,
          "needs the friction that the pressure of the water takes away; give the material `mohr_coulomb`");
  if (scene.has_blow_count()) {
    require(!material.hysteretic, path + ".blow_count",
            "is for strains of ground of one stiffness, not of a hysteretic law; give `cyclic_resistance`");
    return from_blow_count(scene.blow_count());
  }
  const Calibration found = calibrated(material, scene.cyclic_resistance());
  require(
      found.outcome != Calibration::kBeyondStrength, path + ".cyclic_resistance",
      fmt::format("is {:g}, beyond the strength of the material, which fails at {:.3g} by itself; lower it, "
                  "or raise the friction angle",
                  scene.cyclic_resistance(), found.largest_resistance));
  require(found.outcome != Calibration::kFirm, path + ".cyclic_resistance",
          fmt::format("is {:g}, at which no compaction liquefies this material in {:g} cycles; raise it, or "
                      "lower the cohesion",
                      scene.cyclic_resistance(), kLiquefyingCycles));
  return found.compaction;
}

Material read_material(const scene::Material& scene, const scene::Scene& whole, const std::string& path) {
  Material material{scene.density(), scene.young_modulus(), scene.poisson_ratio()};
  const bool reversals = scene.hysteretic().memory() == scene::Hysteretic::REVERSALS;
  require(
      !reversals || !(scene.has_mohr_coulomb() || scene.has_weak_plane()), path + ".hysteretic.memory",
      fmt::format("is `reversals` beside {}, but only elements can stand behind a strength; write `memory: "
                  "elements`",
                  scene.has_mohr_coulomb() ? "mohr_coulomb" : "weak_plane"));
  if (scene.has_mohr_coulomb())
    material.mohr_coulomb = read_mohr_coulomb(scene.mohr_coulomb(), path + ".mohr_coulomb");
  if (scene.has_hysteretic()) read_hysteretic(scene.hysteretic(), path + ".hysteretic", material);
  if (scene.has_weak_plane()) {
    const auto& plane = scene.weak_plane();
    material.weak_plane =
        WeakPlane(plane.dip_angle(), read_strength(plane, kNoStrength, path + ".weak_plane"));
  }
  if (scene.has_fracture()) material.fracture = read_fracture(scene.fracture(), path + ".fracture");
  if (scene.has_pm4sand()) material.pm4sand = read_pm4sand(scene, path);
  if (scene.pores().has_compaction())
    material.compaction = read_compaction(scene.pores().compaction(), material, path + ".pores.compaction");
  require(material.linear() || whole.plane() == scene::PLANE_STRAIN, path,
          "has a strength or a hysteretic curve, which is computed in plane strain only; write `plane: "
          "plane_strain`, "
          "or leave the material elastic");
  return material;
}

// The same material with water in its pores.
Material read_wet(Material dry, const scene::Pores& pores, const scene::Water& water,
                  const std::string& path) {
  const double most = dry.density + pores.porosity() * water.density();
  const double saturated = pores.has_saturated_density() ? pores.saturated_density() : dry.density;
  constexpr double kRounding = 0.01;  // of stated densities
  require(dry.density * (1 - kRounding) <= saturated && saturated <= most * (1 + kRounding),
          path + ".saturated_density",
          fmt::format("is {:g} kg/m^3, but water in pores of {:g} of the volume makes ground of {:g} kg/m^3 "
                      "at most {:g} kg/m^3, and no lighter; correct one of the densities, or the porosity",
                      saturated, pores.porosity(), dry.density, most));
  require(pores.has_conductivity() || !pores.has_conductivity_y(), path + ".conductivity_y",
          "is given without `conductivity`, which is the one along x; state both");
  dry.density = saturated;
  require(dry.density > pores.porosity() * water.density(), path,
          fmt::format("makes ground of {:g} kg/m^3, no heavier than the water in it, {:g} kg/m^3; raise "
                      "saturated_density",
                      dry.density, pores.porosity() * water.density()));
  const double weight = water.density() * protocol::kStandardGravity;
  const double along_y = pores.has_conductivity_y() ? pores.conductivity_y() : pores.conductivity();
  dry.pores = Pores{water.has_bulk_modulus() ? water.bulk_modulus() / pores.porosity() : 0,
                    pores.conductivity() / weight, along_y / weight};
  return dry;
}

// Numbers of wet materials follow those of all stated ones.
void add_wet(const scene::Scene& scene, Ground& ground) {
  const std::size_t count = ground.materials.size();
  for (std::uint32_t m = 0; m < count; ++m) ground.stated.push_back(m);
  if (!scene.has_water()) return;
  for (std::uint32_t m = 0; m < count; ++m) {
    const scene::Material& stated = material_of(scene, m);
    if (!stated.has_pores()) continue;
    ground.materials.push_back(
        read_wet(ground.materials[m], stated.pores(), scene.water(), path_of_material(scene, m) + ".pores"));
    ground.stated.push_back(m);
  }
}

}  // namespace

Ground read_ground(const scene::Scene& scene) {
  const auto& continuum = scene.continuum();
  require(continuum.has_material() || scene.has_material(), "material",
          "is missing; give it, or continuum.material");
  Ground ground;
  ground.plane_stress = scene.plane() == scene::PLANE_STRESS;
  ground.large_strain = continuum.large_strain();
  for (std::size_t m = 0; m <= static_cast<std::size_t>(continuum.materials_size()); ++m)
    ground.materials.push_back(read_material(material_of(scene, m), scene, path_of_material(scene, m)));
  add_wet(scene, ground);
  require(!ground.large_strain || !ground.plane_stress, "continuum.large_strain",
          "is computed in plane strain only; write `plane: plane_strain`, or leave large_strain out");
  return ground;
}

namespace {

std::string name_of_material(std::size_t number) {
  return number > 0 ? fmt::format("continuum.materials[{}]", number - 1) : "the material";
}

// The end of a backbone, beyond which the stress stays: engineering shear strain, shear stress over the
// initial modulus. Nothing where the material has no curve.
std::optional<BackbonePoint> end_of_curve(const Material& material) {
  if (material.reversals) return material.reversals->backbone().back();
  if (!material.hysteretic) return std::nullopt;
  const auto& [stiffness, limit] = *material.hysteretic;
  return BackbonePoint{limit.back(),
                       std::inner_product(stiffness.begin(), stiffness.end(), limit.begin(), 0.0)};
}

}  // namespace

std::vector<std::string> notes_on_strength(const Ground& ground) {
  std::vector<std::string> notes;
  for (std::size_t m = 0; m < ground.stated_materials(); ++m) {
    const Material& material = ground.materials[m];
    if (const auto end = end_of_curve(material))
      notes.push_back(fmt::format(
          "the curve of {} reaches a shear stress of {:.3g} kPa{}, at {:.3g} % of shear strain, and no more "
          "at "
          "any "
          "depth",
          name_of_material(m), end->stress * material.elasticity().shear / 1e3,
          ground.stiffness_factor.empty() ? "" : " times the factor of stiffness", 100 * end->strain));
  }
  return notes;
}

std::vector<std::string> notes_on_resistance(const scene::Scene& scene, const Ground& ground) {
  std::vector<std::string> notes;
  for (std::size_t m = 0; m < ground.stated_materials(); ++m) {
    const scene::Material& stated = material_of(scene, m);
    if (stated.pm4sand().has_cyclic_resistance()) {
      const Pm4Sand& sand = *ground.materials[m].pm4sand;
      notes.push_back(
          fmt::format("pm4sand of {}: cyclic_resistance {:g} makes a contraction_rate of {:.3g}, with "
                      "modulus_coefficient "
                      "{:.4g}",
                      name_of_material(m), stated.pm4sand().cyclic_resistance(), sand.contraction_rate,
                      sand.modulus_coefficient));
    }
    if (const scene::Compaction& compaction = stated.pores().compaction(); compaction.has_cyclic_resistance())
      notes.push_back(fmt::format("compaction of {}: cyclic_resistance {:g} makes C1 = {:.3g}",
                                  name_of_material(m), compaction.cyclic_resistance(),
                                  ground.materials[m].compaction->c1));
  }
  return notes;
}

std::optional<std::string> note_on_fracture(const Ground& ground) {
  std::vector<std::string> names;
  for (std::size_t m = 0; m < ground.stated_materials(); ++m)
    if (const Material& material = ground.materials[m];
        material.fracture && !material.mohr_coulomb && !material.weak_plane)
      names.push_back(name_of_material(m));
  if (names.empty()) return std::nullopt;
  return fmt::format(
      "fracture of {}: zones do not break by it; `demand` and `output.peaks` tell how near they come",
      fmt::join(names, ", "));
}

std::vector<std::string> notes_on_loops(const scene::Scene& scene, const Ground& ground) {
  constexpr double kLittle = 0.005;  // of critical damping, as at smallest strains
  std::vector<std::string> notes;
  for (std::size_t m = 0; m < ground.stated_materials(); ++m) {
    const scene::DampingTable& asked = material_of(scene, m).hysteretic().damping().table();
    double worst = kLittle;
    std::string note;
    for (int i = 0; i < asked.shear_strain_size(); ++i) {
      const double given = ground.materials[m].reversals->damping(asked.shear_strain(i));
      if (asked.ratio(i) - given <= worst) continue;
      worst = asked.ratio(i) - given;
      note = fmt::format(
          "hysteretic.damping: {} asks for {:.3g} % at the shear strain {:g}, but Masing's rules give {:.3g} "
          "% "
          "there, and loops only become narrower than by these; what is missing may be added by "
          "continuum.damping",
          name_of_material(m), 100 * asked.ratio(i), asked.shear_strain(i), 100 * given);
    }
    if (!note.empty()) notes.push_back(note);
  }
  return notes;
}

std::vector<std::uint32_t> materials_of_zones(const scene::Continuum& scene, const Grid& grid) {
  std::vector<std::uint32_t> numbers(grid.zones.size(), 0);
  for (int i = 0; i < scene.materials_size(); ++i)
    if (scene.materials(i).stage() == 0)
      for (const auto zone :
           select_zones(grid, scene.materials(i).where(), fmt::format("continuum.materials[{}].where", i)))
        numbers[zone] = static_cast<std::uint32_t>(i) + 1;
  return numbers;
}

namespace {

std::vector<double> factors_of_zones(const scene::Continuum& scene, scene::Scatter::Property property,
                                     const Grid& grid) {
  const protocol::Scattering scattering(scene.scatter(), property, "continuum.scatter");
  if (scattering.empty()) return {};
  std::vector<double> factors;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const auto [x, y] = centroid(corners(grid, z));
    factors.push_back(scattering.at(x, y));
  }
  return factors;
}

}  // namespace

void assign_zones(const scene::Continuum& scene, const Grid& grid, Ground& ground) {
  ground.of_zone = materials_of_zones(scene, grid);
  ground.stiffness_factor = factors_of_zones(scene, scene::Scatter::STIFFNESS, grid);
  ground.strength_factor = factors_of_zones(scene, scene::Scatter::STRENGTH, grid);
  require(!ground.scattered() ||
              std::ranges::none_of(ground.materials, [](const Material& m) { return m.pm4sand.has_value(); }),
          "continuum.scatter",
          "is given beside pm4sand, whose stiffness follows the pressure; leave one of them out");
}

void compact(Ground& ground, std::span<const double> weights) {
  Ground kept = ground.without_zones();
  for (std::size_t z = 0; z < weights.size(); ++z)
    if (weights[z] != 0) kept.add_zone(ground, z);
  ground = std::move(kept);
}

}  // namespace adit::fdm
