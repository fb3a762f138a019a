// A material: elastic constants, and laws beyond them. A strength (Mohr-Coulomb, a weak plane or both) may
// bound a hysteretic law with a memory of elements (zones/laws/limited_law.hpp).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "fdm_server/hysteresis/iwan_elements.hpp"
#include "fdm_server/hysteresis/polyline.hpp"
#include "fdm_server/materials/compaction.hpp"
#include "fdm_server/materials/mohr_coulomb.hpp"
#include "fdm_server/materials/plane_law.hpp"
#include "fdm_server/materials/pm4sand.hpp"
#include "fdm_server/materials/weak_plane.hpp"

namespace adit::fdm {

// What water in the pores does.
struct Pores {
  double stiffness;       // K_w / n [Pa]; 0: its pressure does not follow the volume
  double permeability_x;  // conductivity over the weight of the water [m^2/(Pa s)]
  double permeability_y;
};

struct Material {
  double density;         // [kg/m^3]
  double young, poisson;  // E [Pa], nu
  std::optional<MohrCoulomb> mohr_coulomb = {};
  std::optional<IwanElements> hysteretic = {};  // a memory of elements
  std::optional<Polyline> reversals = {};       // of reversals, with this backbone
  std::optional<WeakPlane> weak_plane = {};
  std::optional<YieldCone> fracture = {};     // at which its cells would break; zones do not
  std::optional<Pm4Sand> pm4sand = {};        // in place of all others
  std::optional<Compaction> compaction = {};  // under cyclic shear
  std::optional<Pores> pores = {};            // full of water

  bool states_strength() const { return mohr_coulomb || weak_plane || fracture; }
  bool linear() const {
    return !mohr_coulomb && !hysteretic && !reversals && !weak_plane && !compaction && !pm4sand;
  }
  // The stiffest that it may become.
  Elasticity stiffest() const {
    const Elasticity small = elasticity();
    if (!pm4sand) return small;
    const Elasticity sand = small_strain_elasticity(*pm4sand, pm4sand->largest_pressure);
    return {std::max(small.bulk, sand.bulk), std::max(small.shear, sand.shear)};
  }
  double water_stiffness() const { return pores ? pores->stiffness : 0; }
  Elasticity elasticity() const { return {young / (3 * (1 - 2 * poisson)), young / (2 * (1 + poisson))}; }
};

// What the zones of a grid are made of.
struct Ground {
  std::vector<Material> materials;     // as stated, then those of them that have pores, full of water
  std::vector<std::uint32_t> of_zone;  // number of each zone's material
  bool plane_stress = false;           // linear materials in small strain only
  bool large_strain = false;
  // By which the stiffness of each zone's material is multiplied, and its strength; empty: 1 everywhere.
  std::vector<double> stiffness_factor = {}, strength_factor = {};
  std::vector<std::uint32_t> stated = {};  // by number of a material: the number of what the scene states

  bool scattered() const { return !stiffness_factor.empty() || !strength_factor.empty(); }
  const Material& material(std::size_t zone) const { return materials[of_zone[zone]]; }
  double stiffness_of(std::size_t zone) const {
    return stiffness_factor.empty() ? 1 : stiffness_factor[zone];
  }
  double strength_of(std::size_t zone) const { return strength_factor.empty() ? 1 : strength_factor[zone]; }
  PlaneLaw plane_law(const Material& material) const {
    return plane_stress ? fdm::plane_stress(material.young, material.poisson)
                        : plane_strain(material.young, material.poisson);
  }
  // Of a zone, with its factor.
  PlaneLaw plane_law(std::size_t zone) const {
    const auto [bulk, shear] = plane_law(material(zone));
    return {stiffness_of(zone) * bulk, stiffness_of(zone) * shear};
  }
  // With the water that its pores hold and do not let go.
  PlaneLaw undrained_law(std::size_t zone) const {
    const auto [bulk, shear] = plane_law(zone);
    return {bulk + material(zone).water_stiffness(), shear};
  }
  // Number of what the scene states of a zone.
  std::uint32_t stated_of(std::size_t zone) const {
    return stated.empty() ? of_zone[zone] : stated[of_zone[zone]];
  }
  std::vector<std::uint32_t> stated_of_zones() const {
    std::vector<std::uint32_t> numbers;
    for (std::size_t z = 0; z < of_zone.size(); ++z) numbers.push_back(stated_of(z));
    return numbers;
  }
  std::size_t stated_materials() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(materials, [](const Material& m) { return !m.pores; }));
  }
  bool wet(std::size_t zone) const { return material(zone).pores.has_value(); }
  bool any_wet() const {
    return std::ranges::any_of(of_zone, [this](auto m) { return materials[m].pores.has_value(); });
  }
  // Another zone at the end, of the ground of a zone of `other`, which has the same materials.
  void add_zone(const Ground& other, std::size_t zone) {
    of_zone.push_back(other.of_zone[zone]);
    if (!other.stiffness_factor.empty()) stiffness_factor.push_back(other.stiffness_factor[zone]);
    if (!other.strength_factor.empty()) strength_factor.push_back(other.strength_factor[zone]);
  }
  // The same materials without zones.
  Ground without_zones() const { return {materials, {}, plane_stress, large_strain, {}, {}, stated}; }
  bool states_strength() const { return std::ranges::any_of(materials, &Material::states_strength); }
  // Whether its zones' stress is a linear function of the displacements.
  bool is_elastic(const Material& material) const { return material.linear() && !large_strain; }
};

// Density of each zone [kg/m^3].
inline std::vector<double> zone_densities(const Ground& ground) {
  std::vector<double> densities;
  densities.reserve(ground.of_zone.size());
  for (const auto material : ground.of_zone) densities.push_back(ground.materials[material].density);
  return densities;
}

}  // namespace adit::fdm
