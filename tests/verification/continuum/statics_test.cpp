// Requirement: static states reached by relaxation agree with closed forms: stresses within 2 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdm_server/zones/critical_step.hpp"
#include "tests/verification/continuum/grids.hpp"
#include "tests/verification/continuum/oracles/kirsch.hpp"
#include "tests/verification/continuum/oracles/lame.hpp"
#include "tests/verification/continuum/rest.hpp"

namespace adit::fdm::test::statics_test {
namespace {

using oracle::CartesianStress;

constexpr double kPoisson = 0.25, kShear = 1e9, kDensity = 2000;
const PlaneLaw kLaw = plane_strain(2 * (1 + kPoisson) * kShear, kPoisson);
const ZoneKind kKinds[] = {ZoneKind::kAssumedStrain, ZoneKind::kMixedDiscretization};

double norm(const Stress& s) {
  return std::sqrt(s.xx * s.xx + s.yy * s.yy + 2 * s.xy * s.xy);
}

// The largest difference of a zone's stress from the exact one at its centre, as part of a magnitude there.
double largest_error(const Continuum& continuum, const Grid& grid, const StressField& exact,
                     const std::function<double(double x, double y)>& magnitude) {
  double largest = 0;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const auto [x, y] = centroid(corners(grid, z));
    const Stress here = continuum.zones().stress(z), there = exact(x, y);
    largest = std::max(largest,
                       norm({here.xx - there.xx, here.yy - there.yy, here.xy - there.xy}) / magnitude(x, y));
  }
  return largest;
}

double time_step(ZoneKind kind, const Grid& grid) {
  return 0.9 * critical_step(kind, grid, kLaw, kDensity);
}
std::vector<double> masses(const Grid& grid) {
  return lumped_masses(grid, std::vector<double>(grid.zones.size(), 1.0), kDensity);
}

class Statics : public testing::TestWithParam<ZoneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, Statics, testing::ValuesIn(kKinds), [](const auto& kind) {
  return kind.param == ZoneKind::kAssumedStrain ? "AssumedStrain" : "MixedDiscretization";
});

// The hole's wall is free, the outer circle held at the exact displacements.
TEST_P(Statics, KirschStressesAreWithinTwoPercent) {
  const Ring ring{1, 6, 64, 20};
  const Grid grid = ring.grid();
  const auto outer = ring.circle(ring.across);
  const double dt = time_step(GetParam(), grid);
  for (const CartesianStress& far : {CartesianStress{-1e6, 0, 0}, {-1e6, -1e6, 0}, {-1e6, -0.5e6, 0.3e6}}) {
    const oracle::Kirsch kirsch(ring.inner, far, kShear, kPoisson);
    std::vector<std::complex<double>> u(grid.x.size());
    for (const auto i : outer) u[i] = kirsch.displacement(grid.x[i], grid.y[i]);
    Continuum continuum(strained_zones(GetParam(), grid, kLaw, u), masses(grid), {}, held(outer));
    relax(continuum, grid, dt, 1e-6);
    const auto exact = [&](double x, double y) {
      const auto [xx, yy, xy] = kirsch.stress(x, y);
      return Stress{xx, yy, xy};
    };
    const auto magnitude = [&](double x, double y) {  // the local stress, at least the far one
      return std::max(norm(exact(x, y)), norm({far.xx, far.yy, far.xy}));
    };
    EXPECT_LE(largest_error(continuum, grid, exact, magnitude), 0.02);
    double wall = 0, largest = 0;
    for (const auto i : ring.circle(0)) {
      const auto w = kirsch.displacement(grid.x[i], grid.y[i]);
      wall = std::max(wall, std::abs(w - std::complex<double>(continuum.ux()[i], continuum.uy()[i])));
      largest = std::max(largest, std::abs(w));
    }
    EXPECT_LE(wall, 0.01 * largest);
  }
}

// Thick-walled cylinder under its two pressures, free to move.
TEST_P(Statics, LameCylinderIsWithinTwoPercent) {
  const Ring ring{1, 3, 64, 16};
  const Grid grid = ring.grid();
  const oracle::LameCylinder lame(ring.inner, ring.outer, 2e6, 0.5e6, kShear, kPoisson);
  const auto exact = [&](double x, double y) {
    const double r = std::hypot(x, y), c = x / r, s = y / r;
    const auto [radial, hoop] = lame.stress(r);
    return Stress{radial * c * c + hoop * s * s, radial * s * s + hoop * c * c, (radial - hoop) * c * s};
  };
  const auto magnitude = [&](double x, double y) { return norm(exact(x, y)); };
  std::vector<std::uint32_t> outside = ring.circle(ring.across), inside = ring.circle(0);
  outside.push_back(outside.front());
  inside.push_back(inside.front());
  std::ranges::reverse(inside);
  Continuum continuum(ZoneSet(GetParam(), grid, kLaw, std::vector<double>(grid.zones.size(), 1.0)),
                      masses(grid), {traction(grid, outside, exact), traction(grid, inside, exact)}, {});
  relax(continuum, grid, time_step(GetParam(), grid), 1e-6);
  EXPECT_LE(largest_error(continuum, grid, exact, magnitude), 0.02);
  EXPECT_NEAR(continuum.ux()[0], lame.displacement(ring.inner),
              0.01 * std::abs(lame.displacement(ring.inner)));
}

// A line load on the surface of a half-plane (Flamant 1892): s_rr = -2 P cos(theta)/(pi r), all else 0;
// within 2 % from six zones on. Half of the ground is computed, under the exact tractions along its side and
// base.
TEST_P(Statics, FlamantStressesAreWithinTwoPercent) {
  constexpr std::uint32_t kZones = 40;
  const Grid grid = make_grid({0, 1, -1, 0, kZones, kZones});
  const double force = 1e5;
  const auto exact = [&](double x, double y) {
    const double r2 = x * x + y * y, radial = 2 * force * y / (std::numbers::pi * r2);
    return Stress{radial * x * x / r2, radial * y * y / r2, radial * x * y / r2};
  };
  std::vector<std::uint32_t> edge, axis;  // base from the left, then the side upwards
  for (std::uint32_t i = 0; i <= kZones; ++i) edge.push_back(i);
  for (std::uint32_t j = 1; j <= kZones; ++j) edge.push_back(j * (kZones + 1) + kZones);
  for (std::uint32_t j = 0; j <= kZones; ++j) axis.push_back(j * (kZones + 1));
  Continuum continuum(ZoneSet(GetParam(), grid, kLaw, std::vector<double>(grid.zones.size(), 1.0)),
                      masses(grid), {traction(grid, edge, exact), {{axis.back()}, {0}, {-force / 2}, always}},
                      {{axis, Axis::kX, 0, none}, {{kZones}, Axis::kY, 0, none}});
  relax(continuum, grid, time_step(GetParam(), grid), 1e-6);
  const auto magnitude = [&](double x, double y) {  // the largest stress at this distance
    const double r = std::hypot(x, y);
    return r > 6.0 / kZones ? 2 * force / (std::numbers::pi * r) : std::numeric_limits<double>::infinity();
  };
  EXPECT_LE(largest_error(continuum, grid, exact, magnitude), 0.02);
}

// Ground under its weight between smooth walls: s_yy = -rho g depth, s_xx = nu/(1 - nu) s_yy, on each zone.
TEST_P(Statics, GravityGivesTheElasticPressureAtRest) {
  constexpr std::uint32_t kRows = 30, kColumns = 3;
  const Grid grid = make_grid({0, 3, -30, 0, kColumns, kRows});
  const auto weight = masses(grid);
  Load gravity{{}, {}, {}, always};
  std::vector<std::uint32_t> walls, base;
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
    gravity.points.push_back(i);
    gravity.fx.push_back(0);
    gravity.fy.push_back(-9.81 * weight[i]);
    if (grid.x[i] == 0 || grid.x[i] == 3) walls.push_back(i);
    if (grid.y[i] == -30) base.push_back(i);
  }
  Continuum continuum(ZoneSet(GetParam(), grid, kLaw, std::vector<double>(grid.zones.size(), 1.0)), weight,
                      {gravity}, {{walls, Axis::kX, 0, none}, {base, Axis::kY, 0, none}});
  relax(continuum, grid, time_step(GetParam(), grid), 1e-10);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const double exact = 9.81 * kDensity * centroid(corners(grid, z))[1];
    const Stress stress = continuum.zones().stress(z);
    EXPECT_NEAR(stress.yy, exact, 1e-7 * 6e5);
    EXPECT_NEAR(stress.xx, kPoisson / (1 - kPoisson) * exact, 1e-7 * 6e5);
    EXPECT_NEAR(stress.xy, 0, 1e-7 * 6e5);
  }
}

}  // namespace
}  // namespace adit::fdm::test::statics_test
