// Requirement: the force of dashpots is that of their implicit equation, also on an inclined edge, where x
// and y are coupled, and at points of unlike masses or that multipliers tie.
#include "fdm_server/solver/dashpots.hpp"

#include <gtest/gtest.h>

#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::dashpots_test {
namespace {

TEST(Dashpots, SolveTheirImplicitEquation) {
  const Grid grid = make_grid({0, 1, 0, 1, 1, 1});
  const ZoneSet zones(ZoneKind::kMixedDiscretization, grid, {{{2500, 25e9, 0.2}}, {0}}, ones(grid));
  const Symmetric c{3, 1.5, 2};
  const double w[] = {0.2, 0.5}, pull[] = {7, -4}, multiplier[] = {0.5, 0.25}, dt = 0.8;
  for (const bool tied : {false, true})
    for (const bool held : {false, true}) {  // a prescribed component has the inverse mass 0
      double ux[4] = {}, uy[4] = {}, vx[4] = {1.25}, vy[4] = {-0.75}, fx[4] = {pull[0]}, fy[4] = {pull[1]};
      const double mass[4] = {5, 5, 5, 5}, wx[4] = {w[0]}, wy[4] = {held ? 0 : w[1]}, none[4] = {};
      const double tie_x[4] = {multiplier[0]}, tie_y[4] = {multiplier[1]};
      PointArrays points{ux, uy, vx, vy, fx, fy, mass, wx, wy, none, none};
      if (tied) points.tie_x = tie_x, points.tie_y = tie_y;
      Dashpot dashpot{.point = 0, .damping = c};
      BoundaryWork work;
      add_boundary_forces({&dashpot, 1}, false, {}, {.number = 3, .dt = dt}, zones, points, work);
      const Vector f{dashpot.drag.x, dashpot.drag.y};
      EXPECT_EQ(fx[0], pull[0] + f.x);
      EXPECT_EQ(fy[0], pull[1] + f.y);
      // v(n-1/2) and v(n+1/2) under all that acts, the drag included
      const double mean_x = vx[0] + dt / 2 * wx[0] * (pull[0] + f.x + (tied ? multiplier[0] : 0));
      const double mean_y = vy[0] + dt / 2 * wy[0] * (pull[1] + f.y + (tied ? multiplier[1] : 0));
      EXPECT_NEAR(f.x, -(c.xx * mean_x + c.xy * mean_y), 1e-13);
      EXPECT_NEAR(f.y, -(c.xy * mean_x + c.yy * mean_y), 1e-13);
    }
}

// Requirement: when the zones behind some edges of a point are gone, its dashpots, springs and held
// components are those of the other edges.
TEST(Dashpots, GoWithTheZonesBehindThem) {
  const DashpotShare stays{0, {3, 1.5, 2}, {1, 0, 1}, true, false}, goes{1, {5, 0, 4}, {7, 0, 2}, true, true};
  Dashpot dashpot{.point = 0}, alone{.point = 0};
  add(dashpot, goes);
  add(dashpot, stays);
  add(alone, stays);
  leave_out({false, true}, {&dashpot, 1});
  EXPECT_EQ(dashpot.damping, alone.damping);
  EXPECT_EQ(dashpot.spring, alone.spring);
  EXPECT_TRUE(dashpot.hold_x);
  EXPECT_FALSE(dashpot.hold_y);
}

}  // namespace
}  // namespace adit::fdm::test::dashpots_test
