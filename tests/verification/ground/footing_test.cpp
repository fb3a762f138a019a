// Requirement: a strip footing on weightless cohesive ground carries (2 + pi) c (Prandtl 1920) within 2 %,
// with both kinds of zones: nothing locks in plastic flow.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "fdm_server/zones/zone_set.hpp"

namespace adit::fdm::test::footing_test {
namespace {

// Half of a rough footing of half width 1, pushed down until the load stays, slowly: inertia is a thousandth
// of it; the load over (half width + half a zone), because the velocity falls to 0 over the first zone beside
// the footing.
double bearing_pressure(ZoneKind kind, std::uint32_t zones_per_width, const Material& material) {
  const double h = 1.0 / zones_per_width, width = 5, depth = 2;
  const Grid grid = make_grid({0, width, -depth, 0, 5 * zones_per_width, 2 * zones_per_width});
  const std::vector<double> weights(grid.zones.size(), 1.0);
  const Ground ground{{material}, std::vector<std::uint32_t>(grid.zones.size(), 0)};
  const double wave_speed =
      std::sqrt((material.elasticity().bulk + 4 * material.elasticity().shear / 3) / material.density);
  const double cohesion = material.mohr_coulomb->strength(0).cohesion;
  const double speed = 0.1 * cohesion / (material.density * wave_speed);
  const double dt = 0.9 * critical_step(kind, grid, ground);

  std::vector<std::uint32_t> bottom, sides, footing;
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
    const bool under = grid.y[i] == 0 && grid.x[i] <= 1 + 1e-9;
    if (grid.y[i] == -depth) bottom.push_back(i);
    if (under) footing.push_back(i);
    if (grid.y[i] != -depth && (under || grid.x[i] == 0 || grid.x[i] == width)) sides.push_back(i);
  }
  const auto always = [](double) { return 1.0; };
  const double end = 30 * cohesion / material.young / speed, ramp = 0.02 * end;
  Continuum continuum(ZoneSet(kind, grid, ground, weights), lumped_masses(grid, weights, material.density),
                      {},
                      {{bottom, Axis::kX, 0.0, always},
                       {bottom, Axis::kY, 0.0, always},
                       {sides, Axis::kX, 0.0, always},
                       {footing, Axis::kY, -speed, [ramp](double t) { return std::min(1.0, t / ramp); }}});
  const auto steps = static_cast<std::uint64_t>(end / dt), last = steps / 10;
  Energies before{}, after{};
  for (std::uint64_t n = 0; n <= steps; ++n) {
    Energies* wanted = n == steps - last ? &before : n == steps ? &after : nullptr;
    continuum.step({n, dt}, wanted);
  }
  const double distance = speed * static_cast<double>(last) * dt;
  return (after.external_work - before.external_work) / distance / (1 + h / 2);
}

class Footing : public testing::TestWithParam<ZoneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, Footing,
                         testing::Values(ZoneKind::kAssumedStrain, ZoneKind::kMixedDiscretization),
                         [](const auto& kind) {
                           return kind.param == ZoneKind::kAssumedStrain ? "AssumedStrain"
                                                                         : "MixedDiscretization";
                         });

TEST_P(Footing, OnCohesiveGroundCarriesPrandtlsPressure) {
  const double cohesion = 1e5, infinity = std::numeric_limits<double>::infinity();
  Material clay{2000, 250e6, 0.3};
  clay.mohr_coulomb = MohrCoulomb({cohesion, 0, 0, infinity});
  const double expected = (2 + std::numbers::pi) * cohesion;
  const double pressure = bearing_pressure(GetParam(), 8, clay);
  RecordProperty("ratio", std::to_string(pressure / expected));
  EXPECT_NEAR(pressure, expected, 0.02 * expected);
}

}  // namespace
}  // namespace adit::fdm::test::footing_test
