// Requirement: what relaxed to rest stays there, for ten million steps (minutes).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fdm_server/zones/critical_step.hpp"
#include "tests/verification/continuum/grids.hpp"
#include "tests/verification/continuum/rest.hpp"

namespace adit::fdm::test::rest_test {
namespace {

TEST(Rest, LastsTenMillionSteps) {
  const PlaneLaw law = plane_strain(1e9, 0.3);
  const Grid grid = random_grid(8);
  const std::vector<double> ones(grid.zones.size(), 1.0);
  const auto masses = lumped_masses(grid, ones, 2000);
  std::vector<std::uint32_t> base;
  Load gravity{{}, {}, {}, always};
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
    gravity.points.push_back(i);
    gravity.fx.push_back(0);
    gravity.fy.push_back(-9.81 * masses[i]);
    if (grid.y[i] == -1) base.push_back(i);
  }
  const auto kind = ZoneKind::kAssumedStrain;
  const double dt = 0.95 * critical_step(kind, grid, law, 2000);
  Continuum continuum(ZoneSet(kind, grid, law, ones), masses, {gravity}, held(base));
  ASSERT_LT(relax(continuum, grid, dt, 1e-12), 100'000);
  double settled = 0;
  for (const double u : continuum.uy()) settled = std::max(settled, std::abs(u));
  continuum.start_over();
  continuum.reset_displacements();
  for (std::uint64_t n = 0; n <= 10'000'000; ++n) continuum.step({n, dt});
  double moved = 0;
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    moved = std::max({moved, std::abs(continuum.ux()[i]), std::abs(continuum.uy()[i])});
  EXPECT_LE(moved, 1e-9 * settled);
}

}  // namespace
}  // namespace adit::fdm::test::rest_test
