// Requirements on the water in the pores of zones: what it pushes with, what compresses it, its energy, and
// the waves of ground that it cannot leave.
#include "fdm_server/zones/water/pore_water.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "fdm_server/zones/critical_step.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"
#include "tests/unit/fdm_server/solver/standing_wave.hpp"

namespace adit::fdm::test::pore_water_test {
namespace {

constexpr double kWater = 5.5e9;  // K_w / n

// Ground whose pores hold water of this stiffness; also one whose strength makes it nonlinear.
Ground wet_ground(const Grid& grid, double stiffness, bool strong = false) {
  Material material{kDensity, kYoung, kPoisson};
  if (strong) material.mohr_coulomb = MohrCoulomb({1e5, 0.5, 0, 1e5});
  Ground ground{{material}, std::vector<std::uint32_t>(grid.zones.size(), 0)};
  ground.materials[0].pores = Pores{stiffness, 0, 0};
  return ground;
}

struct Motion {
  std::vector<double> ux, uy, vx, vy, fx, fy;
  explicit Motion(std::size_t points) : ux(points), uy(ux), vx(ux), vy(ux), fx(ux), fy(ux) {}
  PointView view() { return {vx.data(), vy.data(), fx.data(), fy.data()}; }
  void move(double dt) {
    for (std::size_t i = 0; i < ux.size(); ++i) {
      ux[i] += dt * vx[i];
      uy[i] += dt * vy[i];
      fx[i] = fy[i] = 0;
    }
  }
};

class WetZones : public testing::TestWithParam<std::tuple<ZoneKind, bool>> {
 protected:
  ZoneKind kind() const { return std::get<0>(GetParam()); }
  bool strong() const { return std::get<1>(GetParam()); }
  Grid grid_ = distorted_grid({0, 3, 0, 2, 6, 5});
};
INSTANTIATE_TEST_SUITE_P(Kinds, WetZones, testing::Combine(testing::ValuesIn(kKinds), testing::Bool()));

// Zones of any shape under a total stress, whatever share of it is the water's, pull on their points as dry
// ones do, and tell the same stress.
TEST_P(WetZones, BearTheTotalStressWhateverTheWaterBears) {
  const Stress total{-3e5, -5e5, 4e4};
  Ground dry = wet_ground(grid_, 0, strong());
  dry.materials[0].pores.reset();
  ZoneSet one(kind(), grid_, dry, ones(grid_)),
      other(kind(), grid_, wet_ground(grid_, kWater, strong()), ones(grid_));
  other.set_rest(std::vector<double>(grid_.zones.size(), 2e5));
  Motion a(grid_.x.size()), b = a;
  for (auto [zones, at] : {std::pair{&one, &a}, {&other, &b}}) {
    zones->follow(at->ux.data(), at->uy.data());
    for (std::size_t z = 0; z < grid_.zones.size(); ++z) zones->set_stress(z, total);
    zones->begin_time();
    zones->add_forces(zones->runs(), 1, at->view());
  }
  for (std::size_t i = 0; i < grid_.x.size(); ++i) {
    EXPECT_NEAR(a.fx[i], b.fx[i], 1e-9 * 5e5);
    EXPECT_NEAR(a.fy[i], b.fy[i], 1e-9 * 5e5);
  }
  EXPECT_NEAR(other.stress(7).xx, total.xx, 1e-6);
  EXPECT_NEAR(other.stress(7).yy, total.yy, 1e-6);
  EXPECT_EQ(other.pore_pressure(7), 2e5);
  EXPECT_NEAR(other.forces(7).x[1], one.forces(7).x[1], 1e-9 * 5e5);
  protocol::Team team(1);
  const std::vector<double> sizes(grid_.zones.size(), 1.0);
  EXPECT_NEAR(other.internal_force(team, sizes), one.internal_force(team, sizes), 1e-9 * 5e5 * 30);
}

// Held as in statics the pressure stays; sealed in it answers a change of volume by M, and no shear.
TEST_P(WetZones, PressureFollowsTheVolumeOnceTimeBegins) {
  ZoneSet zones(kind(), grid_, wet_ground(grid_, kWater, strong()), ones(grid_));
  Motion at(grid_.x.size());
  zones.follow(at.ux.data(), at.uy.data());
  zones.set_rest(std::vector<double>(grid_.zones.size(), 1e5));
  for (std::size_t z = 0; z < grid_.zones.size(); ++z) zones.set_stress(z, {-2e5, -3e5, 0});
  const double exx = -1e-6, eyy = 4e-7, gxy = 3e-6;
  for (std::size_t i = 0; i < grid_.x.size(); ++i) {
    at.vx[i] = exx * grid_.x[i] + gxy * grid_.y[i];
    at.vy[i] = eyy * grid_.y[i];
  }
  at.move(1);
  zones.add_forces(zones.runs(), 1, at.view());
  EXPECT_EQ(zones.pore_pressure(11), 1e5);
  zones.begin_time();
  const double vertical = -(zones.stress(11).yy + 1e5);
  at.move(1);
  zones.add_forces(zones.runs(), 1, at.view());
  const double growth = -kWater * (exx + eyy);
  for (std::size_t z = 0; z < grid_.zones.size(); ++z) {
    EXPECT_NEAR(zones.pore_pressure(z), 1e5 + growth, 1e-9 * 1e5);
    EXPECT_NEAR(zones.pressure_ratio(z), growth / vertical, 1e-9);
  }
}

// What the forces of both ends take up in steps of any motion is stored by skeleton and water, or lost in
// plastic strain and by inflow; flow from zone to zone that keeps the volume of water loses the product of
// inflow and pressure.
TEST_P(WetZones, LedgerClosesWithInflow) {
  ZoneSet zones(kind(), grid_, wet_ground(grid_, kWater, strong()), ones(grid_));
  Motion at(grid_.x.size());
  zones.follow(at.ux.data(), at.uy.data());
  zones.set_rest(std::vector<double>(grid_.zones.size(), 1e5));
  for (std::size_t z = 0; z < grid_.zones.size(); ++z) zones.set_stress(z, {-2e5, -3e5, 0});
  zones.begin_time();
  protocol::Team team(1);
  const double dt = 1e-3;
  at.move(0);
  zones.add_forces(zones.runs(), 0, at.view());
  const double before = zones.strain_energy(team) + zones.dissipated() - zones.external_work();
  double booked = 0, largest = 0;
  for (int step = 0; step < 40; ++step) {
    const Motion last = at;
    for (std::size_t i = 0; i < grid_.x.size(); ++i) {
      at.vx[i] = 2e-3 * std::sin(0.3 * step + 1.7 * static_cast<double>(i));
      at.vy[i] = 2e-3 * std::cos(0.2 * step + 2.3 * static_cast<double>(i));
    }
    std::vector<double> inflow;
    for (std::size_t z = 0; z < grid_.zones.size(); ++z)
      inflow.push_back(1e-7 * std::sin(0.5 * static_cast<double>(z) + step));
    zones.set_inflow(team, inflow);
    at.move(dt);
    zones.add_forces(zones.runs(), dt, at.view());
    for (std::size_t i = 0; i < grid_.x.size(); ++i)
      booked -= dt / 2 * (at.vx[i] * (last.fx[i] + at.fx[i]) + at.vy[i] * (last.fy[i] + at.fy[i]));
    largest = std::max(largest, std::abs(booked));
    EXPECT_NEAR(zones.strain_energy(team) + zones.dissipated() - zones.external_work() - before, booked,
                1e-10 * largest)
        << step;
  }
  EXPECT_GT(largest, 0);
}

// In large strain rigid motion changes no pressure, however far a step turns, and the water pushes on the
// corners as they lie; the change of volume is exact for any step.
TEST_P(WetZones, FollowTheirCornersInLargeStrain) {
  Ground ground = wet_ground(grid_, kWater, strong());
  ground.large_strain = true;
  ZoneSet zones(kind(), grid_, ground, ones(grid_));
  Motion at(grid_.x.size());
  zones.follow(at.ux.data(), at.uy.data());
  zones.set_rest(std::vector<double>(grid_.zones.size(), 1e5));
  for (std::size_t z = 0; z < grid_.zones.size(); ++z)
    zones.set_stress(z, {-1e5, -1e5, 0});  // the water's alone
  zones.begin_time();
  const double before_fx = [&] {
    zones.add_forces(zones.runs(), 0, at.view());
    return at.fx.back();
  }();
  const double before_fy = at.fy.back(), turn = 0.7, c = std::cos(turn), s = std::sin(turn);
  for (std::size_t i = 0; i < grid_.x.size(); ++i) {
    at.vx[i] = (c - 1) * grid_.x[i] - s * grid_.y[i];
    at.vy[i] = s * grid_.x[i] + (c - 1) * grid_.y[i];
  }
  at.move(1);
  zones.add_forces(zones.runs(), 1, at.view());
  EXPECT_NEAR(zones.pore_pressure(9), 1e5, 1e-4);
  EXPECT_NEAR(at.fx.back(), c * before_fx - s * before_fy, 1e-6 * 1e5);
  EXPECT_NEAR(at.fy.back(), s * before_fx + c * before_fy, 1e-6 * 1e5);
  // Then each length grows by a thousandth: the area by 1.001^2 - 1.
  for (std::size_t i = 0; i < grid_.x.size(); ++i) {
    at.vx[i] = 1e-3 * (grid_.x[i] + at.ux[i]);
    at.vy[i] = 1e-3 * (grid_.y[i] + at.uy[i]);
  }
  at.move(1);
  zones.add_forces(zones.runs(), 1, at.view());
  EXPECT_NEAR(zones.pore_pressure(9), 1e5 - kWater * (1.001 * 1.001 - 1), 1e-8 * kWater);
}

// Biot's undrained wave: c^2 = (K + 4/3 G + K_w/n) / density, along every component of the stress.
TEST_P(WetZones, StandingWaveHasBiotsUndrainedSpeed) {
  const auto error = [&](std::uint32_t zones_y) {
    const Grid grid = make_grid(StandingWave::block(zones_y));
    StandingWave wave;
    wave.law.bulk += kWater;
    wave.w = std::sqrt((wave.law.bulk + wave.law.shear) / kDensity * (wave.k * wave.k + wave.l * wave.l));
    Ground ground = wet_ground(grid, kWater);
    if (strong()) ground.materials[0].mohr_coulomb = MohrCoulomb({1e12, 0.5, 0, 1e12});  // which holds
    const double period = 2 * std::numbers::pi / wave.w, step = 0.5 * critical_step(kind(), grid, ground);
    const auto steps = static_cast<std::uint64_t>(std::ceil(2.125 * period / step));
    const double dt = 2.125 * period / static_cast<double>(steps);
    const auto continuum = wave.start(ZoneSet(kind(), grid, ground, ones(grid)), grid, dt);
    continuum->zones().begin_time();
    for (std::uint64_t n = 1; n <= steps; ++n) continuum->step({n, dt});
    double worst = 0, scale = 0;
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
      const auto exact = wave.at(grid.x[i], grid.y[i], 2.125 * period);
      worst =
          std::max({worst, std::abs(continuum->ux()[i] - exact.ux), std::abs(continuum->uy()[i] - exact.uy)});
      scale = std::max({scale, std::abs(exact.ux), std::abs(exact.uy)});
    }
    return worst / scale;
  };
  const double coarse = error(16), fine = error(32);
  EXPECT_LT(fine, 0.005 * 2 * std::numbers::pi * 2.125) << "the phase of a speed that is 0.5 % wrong";
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2);
}

// Of a square zone of side h the stiffest motion is e_xx = e_yy: omega^2 = 8 (kappa + M) / (density h^2).
TEST_P(WetZones, CriticalStepHoldsTheWatersStiffness) {
  const Grid grid = make_grid({0, 0.5, 0, 0.5, 1, 1});
  const double bulk = plane_strain(kYoung, kPoisson).bulk + kWater;
  EXPECT_NEAR(critical_step(kind(), grid, wet_ground(grid, kWater, strong())),
              2 / std::sqrt(8 * bulk / (kDensity * 0.25)), 1e-12);
}

}  // namespace
}  // namespace adit::fdm::test::pore_water_test
