// Requirements: the patch test through the solver to 1e-12; linear and angular momentum of free bodies; the
// energy of an undamped grid never grows by more than 1e-10 of itself a step; all on distorted grids, with
// either zone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "tests/verification/continuum/grids.hpp"

namespace adit::fdm::test::conservation_test {
namespace {

const PlaneLaw kLaw = plane_strain(2.5e9, 0.3);
constexpr double kDensity = 2000;

std::vector<double> masses(const Grid& grid) {
  return lumped_masses(grid, std::vector<double>(grid.zones.size(), 1.0), kDensity);
}
Continuum free_body(ZoneKind kind, const Grid& grid) {
  return {ZoneSet(kind, grid, kLaw, std::vector<double>(grid.zones.size(), 1.0)), masses(grid), {}, {}};
}
// Velocities without any order, which contain all that the grid can do.
void roughen(Continuum& continuum, double scale) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> velocity(-scale, scale);
  for (std::size_t i = 0; i < continuum.vx().size(); ++i) {
    continuum.vx()[i] = velocity(random);
    continuum.vy()[i] = velocity(random);
  }
}

using Parameters = std::tuple<ZoneKind, std::size_t>;
class FreeBody : public testing::TestWithParam<Parameters> {
 protected:
  ZoneKind kind = std::get<0>(GetParam());
  Grid grid = kGridFamilies[std::get<1>(GetParam())].make(10);
  double limit = critical_step(kind, grid, kLaw, kDensity);
};
std::string case_name(const testing::TestParamInfo<Parameters>& info) {
  const auto [kind, family] = info.param;
  return (kind == ZoneKind::kAssumedStrain ? "AssumedStrain" : "MixedDiscretization") +
         kGridFamilies[family].name;
}
INSTANTIATE_TEST_SUITE_P(Grids, FreeBody,
                         testing::Combine(testing::Values(ZoneKind::kAssumedStrain,
                                                          ZoneKind::kMixedDiscretization),
                                          testing::Range(std::size_t{0}, std::size(kGridFamilies))),
                         case_name);

// A linear velocity field, kept up along the edge, strains all zones alike: the inner points go on as they
// began, and every stress is Hooke's of the strain, to 1e-12.
TEST_P(FreeBody, PassesThePatchTest) {
  const double exx = 1e-3, eyy = -4e-4, gxy = 7e-4, turn = 3e-4;
  const auto vx = [=](double x, double y) { return 2e-3 + exx * x + (gxy / 2 - turn) * y; };
  const auto vy = [=](double x, double y) { return -1e-3 + eyy * y + (gxy / 2 + turn) * x; };
  std::vector<PrescribedMotion> motions;
  for (const auto i : edge_points(grid)) {
    motions.push_back({{i}, Axis::kX, vx(grid.x[i], grid.y[i]), [](double) { return 1.0; }});
    motions.push_back({{i}, Axis::kY, vy(grid.x[i], grid.y[i]), [](double) { return 1.0; }});
  }
  Continuum continuum(ZoneSet(kind, grid, kLaw, std::vector<double>(grid.zones.size(), 1.0)), masses(grid),
                      {}, std::move(motions));
  const double dt = 0.9 * limit;
  continuum.step({0, dt});
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    continuum.vx()[i] = vx(grid.x[i], grid.y[i]);
    continuum.vy()[i] = vy(grid.x[i], grid.y[i]);
  }
  constexpr std::uint64_t kSteps = 500;
  for (std::uint64_t n = 1; n <= kSteps; ++n) continuum.step({n, dt});
  const double time = kSteps * dt, mean = kLaw.bulk * (exx + eyy) * time,
               side = kLaw.shear * (exx - eyy) * time;
  const double scale = kLaw.bulk * exx * time;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const Stress stress = continuum.zones().stress(z);
    EXPECT_NEAR(stress.xx, mean + side, 1e-12 * scale);
    EXPECT_NEAR(stress.yy, mean - side, 1e-12 * scale);
    EXPECT_NEAR(stress.xy, kLaw.shear * gxy * time, 1e-12 * scale);
  }
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    EXPECT_NEAR(continuum.vx()[i], vx(grid.x[i], grid.y[i]), 1e-12);
    EXPECT_NEAR(continuum.vy()[i], vy(grid.x[i], grid.y[i]), 1e-12);
  }
}

// A body that flies and turns, by as much as it is large, is free of stress: to the rounding of its
// displacements by the stiffness. (Small strain: the displacements of a small rotation, however large they
// are.)
TEST_P(FreeBody, MovesAndTurnsWithoutStress) {
  Continuum continuum = free_body(kind, grid);
  const double dt = 0.9 * limit;
  constexpr std::uint64_t kSteps = 500;
  const double rate = 1 / (kSteps * dt);
  continuum.step({0, dt});
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    continuum.vx()[i] = rate * (1 - grid.y[i]);
    continuum.vy()[i] = rate * (0.5 + grid.x[i]);
  }
  for (std::uint64_t n = 1; n <= kSteps; ++n) continuum.step({n, dt});
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const Stress stress = continuum.zones().stress(z);
    EXPECT_LE(std::max({std::abs(stress.xx), std::abs(stress.yy), std::abs(stress.xy)}), 1e-12 * kLaw.bulk);
  }
}

struct Momenta {
  double x = 0, y = 0, angular = 0, size = 0;
};
Momenta momenta(const Continuum& continuum, const Grid& grid) {
  Momenta all;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    const double px = continuum.masses()[i] * continuum.vx()[i],
                 py = continuum.masses()[i] * continuum.vy()[i];
    all.x += px;
    all.y += py;
    all.angular += grid.x[i] * py - grid.y[i] * px;
    all.size += std::hypot(px, py);
  }
  return all;
}

TEST_P(FreeBody, KeepsItsLinearAndAngularMomentum) {
  Continuum continuum = free_body(kind, grid);
  const double dt = 0.9 * limit;
  continuum.step({0, dt});
  roughen(continuum, 1);
  const Momenta before = momenta(continuum, grid);
  for (std::uint64_t n = 1; n <= 3000; ++n) continuum.step({n, dt});
  const Momenta after = momenta(continuum, grid);
  EXPECT_NEAR(after.x, before.x, 1e-12 * before.size);
  EXPECT_NEAR(after.y, before.y, 1e-12 * before.size);
  EXPECT_NEAR(after.angular, before.angular, 1e-12 * before.size);
}

// Near the critical step, from the roughest start: not by more than 1e-10 in any step, nor by 1e-11 in all.
TEST_P(FreeBody, NeverGainsEnergy) {
  Continuum continuum = free_body(kind, grid);
  const double dt = 0.999 * limit;
  continuum.step({0, dt});
  roughen(continuum, 1);
  Energies energies{};
  continuum.step({1, dt}, &energies);
  const double first = energies.kinetic + energies.strain;
  double before = first, largest_gain = 0, drift = 0;
  for (std::uint64_t n = 2; n <= 10'000; ++n) {
    continuum.step({n, dt}, &energies);
    const double now = energies.kinetic + energies.strain;
    largest_gain = std::max(largest_gain, now - before);
    drift = std::max(drift, std::abs(now - first));
    before = now;
  }
  EXPECT_GT(first, 0);
  EXPECT_LE(largest_gain, 1e-10 * first);
  EXPECT_LE(drift, 1e-11 * first);
}

}  // namespace
}  // namespace adit::fdm::test::conservation_test
