// Requirements at the extremes: nearly incompressible ground, slender zones, large coordinates; and that what
// relaxed to rest stays there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fdm_server/zones/critical_step.hpp"
#include "tests/verification/continuum/wave_run.hpp"

namespace adit::fdm::test::extremes_test {
namespace {

using std::numbers::pi;

double limit(ZoneKind kind, const Grid& grid, const Medium& medium) {
  return critical_step(kind, grid, medium.law, medium.density);
}

// Errors of one and a third periods at a step just below the limit.
Errors errors(ZoneKind kind, const Grid& grid, const HarmonicWave& wave, bool free_surface) {
  const double end = 2.7 * pi / wave.omega();
  const double steps = std::ceil(end / (0.95 * limit(kind, grid, wave.medium())));
  return WaveRun(kind, grid, wave, free_surface, end, static_cast<std::uint64_t>(steps)).errors();
}

class Extremes : public testing::TestWithParam<ZoneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, Extremes,
                         testing::Values(ZoneKind::kAssumedStrain, ZoneKind::kMixedDiscretization),
                         [](const auto& kind) {
                           return kind.param == ZoneKind::kAssumedStrain ? "AssumedStrain"
                                                                         : "MixedDiscretization";
                         });

// Zones of ground that hardly changes its volume (nu = 0.499) do not lock: SV and Rayleigh waves on random
// grids are as good as at nu = 0.3.
TEST_P(Extremes, NearlyIncompressibleGroundDoesNotLock) {
  const Medium usual{plane_strain(1e9, 0.3), 2000}, soft{plane_strain(1e9, 0.499), 2000};
  const Grid grid = random_grid(24);
  for (const bool is_rayleigh : {false, true}) {
    const auto wave = [&](const Medium& medium) {
      return is_rayleigh ? oracle::rayleigh_wave(medium, 0.8) : oracle::sv_wave(medium, 0.7, 1.1);
    };
    const Errors reference = errors(GetParam(), grid, wave(usual), is_rayleigh);
    const Errors here = errors(GetParam(), grid, wave(soft), is_rayleigh);
    EXPECT_LE(here.displacement, 1.5 * reference.displacement);
    EXPECT_LE(here.velocity, 1.5 * reference.velocity);
  }
}

// Waves along zones 20 times as long as high, distorted at random, are as good as on square zones of this
// length.
TEST_P(Extremes, SlenderZonesAreAsGoodAsTheirLength) {
  const Medium medium{plane_strain(1e9, 0.3), 2000};
  constexpr std::uint32_t kZones = 24;
  const Grid square = make_grid({0, 20, -20, 0, kZones, kZones});
  const Grid slender = mapped(random_grid(kZones), [](double x, double y) { return std::array{20 * x, y}; });
  for (const auto& wave : {oracle::p_wave(medium, 16, 0.2), oracle::sv_wave(medium, 16, 0.2)}) {
    const Errors reference = errors(GetParam(), square, wave, false);
    const Errors here = errors(GetParam(), slender, wave, false);
    EXPECT_LE(here.displacement, 1.2 * reference.displacement);
    EXPECT_LE(here.velocity, 1.2 * reference.velocity);
  }
}

// Velocities of a free body after many steps from a rough start.
std::vector<double> shaken(ZoneKind kind, const Grid& grid, double dt) {
  const Medium medium{plane_strain(1e9, 0.3), 2000};
  const std::vector<double> ones(grid.zones.size(), 1.0);
  Continuum continuum(ZoneSet(kind, grid, medium.law, ones), lumped_masses(grid, ones, medium.density), {},
                      {});
  continuum.step({0, dt});
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    continuum.vx()[i] = std::sin(1.7 * static_cast<double>(i * i));
  for (std::uint64_t n = 1; n <= 1000; ++n) continuum.step({n, dt});
  return {continuum.vx().begin(), continuum.vx().end()};
}

// Coordinates in a country's grid, a million metres from its origin, cost no more than their own rounding.
TEST_P(Extremes, LargeCoordinatesChangeOnlyTheRounding) {
  const Grid here = mapped(random_grid(16), [](double x, double y) { return std::array{16 * x, 16 * y}; });
  const Grid there = mapped(here, [](double x, double y) { return std::array{x + 1e6, y - 3e6}; });
  const double dt = 0.9 * limit(GetParam(), here, {plane_strain(1e9, 0.3), 2000});
  const auto a = shaken(GetParam(), here, dt), b = shaken(GetParam(), there, dt);
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference = std::max(difference, std::abs(a[i] - b[i]));
  EXPECT_LE(difference, 1e-6);
}

}  // namespace
}  // namespace adit::fdm::test::extremes_test
