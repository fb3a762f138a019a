// Requirements on the speed of waves over regular grids: the solver's waves travel as the zones' stiffness
// and central differences say, to rounding; and the advice of docs/continuum.md on zones a wavelength holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fdm_server/solver/continuum.hpp"
#include "tests/verification/continuum/dispersion.hpp"
#include "tests/verification/continuum/oracles/harmonic_wave.hpp"

namespace adit::fdm::test::dispersion_test {
namespace {

using oracle::Medium;
using std::numbers::pi;

const Medium kMedium{plane_strain(1e9, 0.3), 2000};
constexpr double kStepFactor = 0.9;

class DispersionOfEachZone : public testing::TestWithParam<ZoneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, DispersionOfEachZone,
                         testing::Values(ZoneKind::kAssumedStrain, ZoneKind::kMixedDiscretization),
                         [](const auto& kind) {
                           return kind.param == ZoneKind::kAssumedStrain ? "AssumedStrain"
                                                                         : "MixedDiscretization";
                         });

// Along the zones' sides both waves are those of a chain: omega_s = 2 c/h sin(k h/2).
TEST_P(DispersionOfEachZone, IsThatOfAChainAlongTheZones) {
  const double h = 0.5, dt = kStepFactor * critical_step(GetParam(), make_grid({0, h, 0, h, 1, 1}),
                                                         kMedium.law, kMedium.density);
  const Dispersion dispersion(GetParam(), h, h, kMedium.law, kMedium.density, kStepFactor);
  for (const double k : {0.1, 1.0, 3.0}) {
    const auto [s, p] = dispersion.speeds(k, 0);
    const auto chain = [&](double c) { return 2 / (k * dt) * std::asin(c * dt / h * std::sin(k * h / 2)); };
    EXPECT_NEAR(s, chain(kMedium.s_speed()), 1e-12 * s);
    EXPECT_NEAR(p, chain(kMedium.p_speed()), 1e-12 * p);
  }
}

// Standing waves between smooth walls, u_x = sin(kx) cos(ky), u_y = +-cos(kx) sin(ky): four P or S waves at
// 45 degrees, which the walls mirror into each other. The solver keeps their shape and frequency to rounding.
TEST_P(DispersionOfEachZone, IsTheSolversAtFortyFiveDegrees) {
  constexpr std::uint32_t kZones = 12;
  const Grid grid = make_grid({0, 1, 0, 1, kZones, kZones});
  const std::vector<double> ones(grid.zones.size(), 1.0);
  std::vector<std::uint32_t> x_walls, y_walls;
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
    if (grid.x[i] == 0 || grid.x[i] == 1) x_walls.push_back(i);
    if (grid.y[i] == 0 || grid.y[i] == 1) y_walls.push_back(i);
  }
  const double k = 2 * pi, total = std::numbers::sqrt2 * k;
  const Dispersion dispersion(GetParam(), 1.0 / kZones, 1.0 / kZones, kMedium.law, kMedium.density,
                              kStepFactor);
  const double dt = kStepFactor * critical_step(GetParam(), grid, kMedium.law, kMedium.density);
  for (const bool is_p : {false, true}) {
    const double omega = total * dispersion.speeds(total, pi / 4)[is_p], sign = is_p ? 1 : -1;
    Continuum continuum(ZoneSet(GetParam(), grid, kMedium.law, ones),
                        lumped_masses(grid, ones, kMedium.density), {},
                        {{x_walls, Axis::kX, 0, [](double) { return 0.0; }},
                         {y_walls, Axis::kY, 0, [](double) { return 0.0; }}});
    const auto shape_x = [&](std::size_t i) { return std::sin(k * grid.x[i]) * std::cos(k * grid.y[i]); };
    const auto shape_y = [&](std::size_t i) {
      return sign * std::cos(k * grid.x[i]) * std::sin(k * grid.y[i]);
    };
    continuum.step({0, dt});
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
      continuum.vx()[i] = shape_x(i);
      continuum.vy()[i] = shape_y(i);
    }
    constexpr std::uint64_t kSteps = 500;
    for (std::uint64_t n = 1; n <= kSteps; ++n) continuum.step({n, dt});
    const double amplitude = dt / std::sin(omega * dt), now = amplitude * std::sin(omega * kSteps * dt);
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
      EXPECT_NEAR(continuum.ux()[i], now * shape_x(i), 1e-11 * amplitude);
      EXPECT_NEAR(continuum.uy()[i], now * shape_y(i), 1e-11 * amplitude);
    }
  }
}

// The largest relative error of a speed over all directions (and of the Rayleigh wave), nu from 0.1 to 0.45.
double largest_error(ZoneKind kind, std::uint32_t zones) {
  double largest = 0;
  for (const double poisson : {0.1, 0.25, 0.35, 0.45}) {
    const Medium medium{plane_strain(1e9, poisson), 2000};
    const Dispersion dispersion(kind, 1, 1, medium.law, medium.density, kStepFactor);
    const double k = 2 * pi / zones;
    for (int i = 0; i <= 8; ++i) {
      const auto [s, p] = dispersion.speeds(k, pi / 4 * i / 8);
      largest = std::max({largest, std::abs(s / medium.s_speed() - 1), std::abs(p / medium.p_speed() - 1)});
    }
    largest =
        std::max(largest, std::abs(dispersion.rayleigh_speed(k, 3 * zones) / rayleigh_speed(medium) - 1));
  }
  return largest;
}

// 8 zones to a wavelength keep every speed within 4 %, 12 within 2 %, 16 within 1 %, 24 within 0.5 %.
TEST_P(DispersionOfEachZone, KeepsTheAdviceOnZonesAWavelength) {
  EXPECT_LE(largest_error(GetParam(), 8), 0.04);
  EXPECT_LE(largest_error(GetParam(), 12), 0.02);
  EXPECT_LE(largest_error(GetParam(), 16), 0.01);
  EXPECT_LE(largest_error(GetParam(), 24), 0.005);
}

}  // namespace
}  // namespace adit::fdm::test::dispersion_test
