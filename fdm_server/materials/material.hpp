// A material: elastic constants, and at most one law beyond them; a weak plane may cut any but the hysteretic
// one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fdm_server/materials/hysteretic.hpp"
#include "fdm_server/materials/mohr_coulomb.hpp"
#include "fdm_server/materials/weak_plane.hpp"
#include "fdm_server/zones/plane_law.hpp"

namespace adit::fdm {

struct Material {
  double density;         // [kg/m^3]
  double young, poisson;  // E [Pa], nu
  std::optional<MohrCoulomb> mohr_coulomb = {};
  std::optional<Hysteretic> hysteretic = {};
  std::optional<WeakPlane> weak_plane = {};

  bool linear() const { return !mohr_coulomb && !hysteretic && !weak_plane; }
  Elasticity elasticity() const { return {young / (3 * (1 - 2 * poisson)), young / (2 * (1 + poisson))}; }
};

// What the zones of a grid are made of.
struct Ground {
  std::vector<Material> materials;
  std::vector<std::uint32_t> of_zone;  // number of each zone's material
  bool plane_stress = false;           // linear materials in small strain only
  bool large_strain = false;

  PlaneLaw plane_law(const Material& material) const {
    return plane_stress ? fdm::plane_stress(material.young, material.poisson)
                        : plane_strain(material.young, material.poisson);
  }
};

}  // namespace adit::fdm
