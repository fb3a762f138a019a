// Requirements on the demand of zones: that of the largest stress in an elastic zone, and 1 in the step in
// which a zone begins to yield.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "fdm_server/zones/nonlinear/nonlinear_zones.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::demand_of_zones_test {
namespace {

constexpr double kTensile = 3e6, kFriction = 0.5;
const YieldCone kFracture = MohrCoulomb({20e6, kFriction, 0, kTensile}).cone(0);

struct Motion {
  std::vector<double> x, y;
};

// Pure bending about the axis y = 0: exx = curvature y, eyy = -nu' exx.
Motion bent(const Grid& grid, double curvature, double poisson) {
  Motion motion;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    const double x = grid.x[i], y = grid.y[i];
    motion.x.push_back(curvature * x * y);
    motion.y.push_back(-curvature * (x * x + poisson * y * y) / 2);
  }
  return motion;
}

// A row of zones that is bent, one zone thick: the demand is that of the outermost fibre, E' curvature h / 2
// over the tensile strength, in each zone; mirrored about its axis the same.
TEST(DemandOfZones, IsThatOfTheOutermostFibreOfABeam) {
  const double height = 0.4, curvature = 4e-4;
  const Grid grid = make_grid({-1, 1, -height / 2, height / 2, 5, 1});
  const PlaneLaw law = plane_stress(kYoung, kPoisson);
  for (const double sign : {1.0, -1.0}) {
    ElasticZones zones(ZoneKind::kAssumedStrain, grid, law, ones(grid), 0, kFracture);
    const Motion motion = bent(grid, sign * curvature, law.poisson_prime());
    zones.follow(motion.x.data(), motion.y.data());
    for (std::size_t z = 0; z < zones.count(); ++z)
      EXPECT_NEAR(zones.demand(z), kYoung * curvature * height / 2 / kTensile, 1e-9);
  }
}

// Uniform strain of distorted zones of both kinds: the demand is that of the one stress.
TEST(DemandOfZones, IsThatOfTheStressWhereItIsUniform) {
  const Grid grid = distorted_grid({-1, 1, 0, 1, 5, 4});
  const PlaneLaw law = plane_stress(kYoung, kPoisson);
  const double strain = 0.6 * kTensile / kYoung;
  Motion motion;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    motion.x.push_back(strain * grid.x[i]);
    motion.y.push_back(-kPoisson * strain * grid.y[i]);
  }
  for (const ZoneKind kind : kKinds) {
    ElasticZones zones(kind, grid, law, ones(grid), 0, kFracture);
    zones.follow(motion.x.data(), motion.y.data());
    for (std::size_t z = 0; z < zones.count(); ++z) EXPECT_NEAR(zones.demand(z), 0.6, 1e-9);
    std::vector<bool> gone(zones.count(), false);
    gone[3] = true;
    zones.remove(gone);
    EXPECT_EQ(zones.demand(3), 0);
  }
  ElasticZones without(ZoneKind::kAssumedStrain, grid, law, ones(grid));
  without.follow(motion.x.data(), motion.y.data());
  EXPECT_EQ(without.demand(0), 0);
}

// Strained evenly until it yields, softens and is turned about: below 1 while it is elastic, 1 while it
// yields, whatever strength is left.
TEST(DemandOfZones, IsOneWhileTheyYield) {
  const Strength strong{60e3, 0.5, 0.1, 40e3}, weak{20e3, 0.4, 0, 5e3};
  const Grid grid = make_grid({0, 1, 0, 1, 2, 2});
  constexpr double kNoTension = std::numeric_limits<double>::infinity();
  const MohrCoulomb softening({{0, strong}, {0.1, weak}});
  for (const bool large_strain : {false, true})
    for (const Material& material : {Material{2000, 100e6, 0.3, softening},
                                     Material{2000, 100e6, 0.3, MohrCoulomb({30e3, 0, 0, kNoTension})},
                                     Material{.density = 2000,
                                     .young = 100e6,
                                     .poisson = 0.3,
                                     .weak_plane = WeakPlane(0.6, {20e3, 0.2, 0, 5e3})}}) {
      int elastic = 0, yielding = 0;
      for (const auto& [exx, eyy, gxy] : {std::array{0.0, -2e-5, 1e-5}, {2e-5, 0.0, 0.0}, {0.0, 0.0, 3e-5}}) {
        NonlinearZones zones(ZoneKind::kAssumedStrain, grid, material, ones(grid), large_strain);
        const std::size_t n = grid.x.size();
        std::vector<double> ux(n), uy(n), vx(n), vy(n), fx(n), fy(n);
        for (std::size_t i = 0; i < n; ++i) {
          vx[i] = exx * grid.x[i] + gxy * grid.y[i];
          vy[i] = eyy * grid.y[i];
        }
        zones.follow(ux.data(), uy.data());
        for (int step = 0; step < 600; ++step) {
          for (std::size_t i = 0; i < n; ++i) {
            ux[i] += vx[i];
            uy[i] += vy[i];
          }
          zones.add_forces(1, {vx.data(), vy.data(), fx.data(), fy.data()});
          const auto now = static_cast<unsigned>(zones.field(0, ZoneField::kYieldState)) &
                           (kShearNow | kTensionNow | kSlipNow | kOpeningNow);
          // a strength that softens falls in the step whose stress still had the larger one
          if (now)
            EXPECT_NEAR(zones.demand(0), 1, 2e-3);
          else
            EXPECT_LE(zones.demand(0), 1);
          now ? ++yielding : ++elastic;
        }
      }
      EXPECT_GT(yielding, 500);
      EXPECT_GT(elastic, 20);
    }
}

}  // namespace
}  // namespace adit::fdm::test::demand_of_zones_test
