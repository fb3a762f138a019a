// What the laws of the ground cost: zone-steps per second of one thread in a block of 100 x 100 zones of one
// material, one JSON object a line. `failing`: all sampling points are beyond their strength in all steps, in
// shear alone, or torn to the apex of the cone.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <vector>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "fdm_server/zones/zone_set.hpp"

namespace {

using namespace adit::fdm;

// The best of some windows of about 10 ms.
double zone_steps_per_second(ZoneKind kind, const Material& material, bool large_strain, double stretch) {
  const Grid grid = make_grid({0, 100, 0, 100, 100, 100});
  const std::size_t zones = grid.zones.size();
  const std::vector<double> ones(zones, 1.0);
  const Ground ground{{material}, std::vector<std::uint32_t>(zones, 0), false, large_strain};
  Continuum continuum(ZoneSet(kind, grid, ground, ones), lumped_masses(grid, ones, material.density), {}, {});
  const double dt = 0.5 * critical_step(kind, grid, ground);
  std::uint64_t n = 0;
  continuum.step({n++, dt});
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    continuum.vx()[i] = 1e-2 * (stretch * grid.x[i] + std::sin(grid.y[i]));
    continuum.vy()[i] = 1e-2 * (stretch * grid.y[i] + std::cos(grid.x[i]));
  }
  double best = 1e9;
  for (int window = 0; window < 30; ++window) {
    const auto start = std::chrono::steady_clock::now();
    constexpr int kSteps = 10;
    for (int i = 0; i < kSteps; ++i) continuum.step({n++, dt});
    best = std::min(best,
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / kSteps);
  }
  return static_cast<double>(zones) / best;
}

}  // namespace

int main() {
  const Material elastic{2000, 1e9, 0.3};
  const auto frictional = [&](double cohesion) {
    Material material = elastic;
    material.mohr_coulomb = MohrCoulomb({cohesion, 0.5, 0.1, 0});
    return material;
  };
  Material hysteretic = elastic, bedded = frictional(1e12);
  hysteretic.hysteretic = Hysteretic(backbone(hyperbola(1e-3, 1), 2e-6, 1e-2, 60));
  bedded.weak_plane = WeakPlane(0.5, {1e12, 0.4, 0, std::numeric_limits<double>::infinity()});
  const auto cohesive_of = [&](double cohesion) {
    Material material = elastic;
    material.mohr_coulomb = MohrCoulomb({cohesion, 0, 0, std::numeric_limits<double>::infinity()});
    return material;
  };
  const Material strong = cohesive_of(1e12), cohesive = cohesive_of(1);
  struct Law {
    const char* name;
    Material material;
    bool large_strain;
    double stretch;  // of the ground in all directions, beside the shear
  };
  for (const auto kind : {ZoneKind::kAssumedStrain, ZoneKind::kMixedDiscretization})
    for (const auto& [name, material, large_strain, stretch] :
         {Law{"elastic", elastic, false, 1}, Law{"Mohr-Coulomb, within its strength", strong, false, 1},
          Law{"Mohr-Coulomb, failing in shear", cohesive, false, 0},
          Law{"Mohr-Coulomb, failing in tension", frictional(1), false, 1},
          Law{"Mohr-Coulomb and weak plane", bedded, false, 1},
          Law{"hysteretic, 60 elements", hysteretic, false, 1},
          Law{"elastic, large strain", elastic, true, 1}})
      std::printf("{\"kind\": \"%s\", \"law\": \"%s\", \"zone_steps_per_s\": %.4g}\n",
                  kind == ZoneKind::kAssumedStrain ? "assumed strain" : "mixed discretization", name,
                  zone_steps_per_second(kind, material, large_strain, stretch));
}
