// What the laws of the ground cost: zone-steps per second of one thread and of two in a block of 316 x 316
// zones of one material, one JSON object a line. `failing`: all sampling points are beyond their strength in
// all steps, in shear alone, or torn to the apex of the cone.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <vector>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "tests/bench/measure.hpp"

namespace {

using namespace adit::fdm;

// The least time of some windows of a few steps.
double zone_steps_per_second(ZoneKind kind, const Material& material, bool large_strain, double stretch,
                             std::size_t threads) {
  constexpr std::uint32_t kSide = 316;
  const Grid grid = make_grid({0, kSide, 0, kSide, kSide, kSide});
  const std::size_t zones = grid.zones.size();
  const std::vector<double> ones(zones, 1.0);
  const Ground ground{{material}, std::vector<std::uint32_t>(zones, 0), false, large_strain};
  Continuum continuum(ZoneSet(kind, grid, ground, ones), lumped_masses(grid, ones, material.density), {}, {},
                      threads);
  const double dt = 0.5 * critical_step(kind, grid, ground);
  std::uint64_t n = 0;
  continuum.step({n++, dt});
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    continuum.vx()[i] = 1e-2 * (stretch * grid.x[i] + std::sin(grid.y[i]));
    continuum.vy()[i] = 1e-2 * (stretch * grid.y[i] + std::cos(grid.x[i]));
  }
  double best = 1e9;
  for (double left = 1; left > 0;) {  // s
    constexpr int kSteps = 3;
    const double spent = adit::bench::seconds(threads, [&] {
      for (int i = 0; i < kSteps; ++i) continuum.step({n++, dt});
    });
    left -= spent;
    best = std::min(best, spent / kSteps);
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
  Material hysteretic = elastic, reversals = elastic, narrow = elastic, bedded = frictional(1e12);
  const auto curve = backbone(hyperbola(1e-3, 1), 2e-6, 1e-2, 60);
  hysteretic.hysteretic = iwan_elements(curve);
  reversals.reversals = narrow.reversals = Polyline(curve);
  narrow.reversals->narrow([](double strain) { return 0.6 * std::pow(1 + strain / 1e-3, -0.1); }, "");
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
          Law{"hysteretic, reversals", reversals, false, 1},
          Law{"hysteretic, reversals, narrow loops", narrow, false, 1},
          Law{"elastic, large strain", elastic, true, 1}})
      for (const std::size_t threads : {1, 2})
        std::printf("{\"kind\": \"%s\", \"law\": \"%s\", \"threads\": %zu, \"zone_steps_per_s\": %.4g}\n",
                    kind == ZoneKind::kAssumedStrain ? "assumed strain" : "mixed discretization", name,
                    threads, zone_steps_per_second(kind, material, large_strain, stretch, threads));
}
