// Requirements on zones with a law: elastic ones are those of the fast kernels, the energy ledger closes for
// every law, rigid motion of any size strains nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "fdm_server/zones/nonlinear/nonlinear_zones.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::nonlinear_zones_test {
namespace {

using std::numbers::pi;

constexpr double kDegree = pi / 180;
const Material kElastic{kDensity, kYoung, kPoisson};

Ground all_of(const Grid& grid, const Material& material, bool large_strain = false) {
  return {{material}, std::vector<std::uint32_t>(grid.zones.size(), 0), false, large_strain};
}

// A load that brings every law of `laws()` far beyond its limit within the tests' hundredths of a second.
struct Law {
  const char* name;
  Material material;
};
std::vector<Law> laws() {
  const double strength = 2e6;
  Material cohesive = kElastic, frictional = kElastic, softening = kElastic, hysteretic = kElastic,
           reversals = kElastic, narrow = kElastic, bedded = kElastic;
  cohesive.mohr_coulomb = MohrCoulomb({strength, 0, 0, 0.7 * strength});
  frictional.mohr_coulomb = MohrCoulomb({strength, 35 * kDegree, 10 * kDegree, 0.2 * strength});
  softening.mohr_coulomb =
      MohrCoulomb({{0, {strength, 0.6, 0.2, 0.5 * strength}}, {1e-3, {0.1 * strength, 0.5, 0, 0}}});
  const auto curve = backbone(hyperbola(1e-4, 1), 1e-6, 1e-3, 30);
  hysteretic.hysteretic = iwan_elements(curve);
  reversals.reversals = narrow.reversals = Polyline(curve);
  narrow.reversals->narrow(darendeli_share(hyperbola(1e-4, 1), 10), "");
  bedded.mohr_coulomb = frictional.mohr_coulomb;
  bedded.weak_plane = WeakPlane(0.6, {0.3 * strength, 25 * kDegree, 5 * kDegree, 0.1 * strength});
  return {{"cohesive", cohesive},     {"frictional", frictional}, {"softening", softening},
          {"hysteretic", hysteretic}, {"reversals", reversals},   {"narrow loops", narrow},
          {"bedded", bedded}};
}

class NonlinearZonesOfEachKind : public testing::TestWithParam<ZoneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, NonlinearZonesOfEachKind, testing::ValuesIn(kKinds), [](const auto& kind) {
  return kind.param == ZoneKind::kAssumedStrain ? "AssumedStrain" : "MixedDiscretization";
});

// Elastic zones of the general kernel are those of the fast one: forces, energy and stress on a grid of
// rectangles, and of mixed discretization on any grid.
TEST_P(NonlinearZonesOfEachKind, ElasticOnesAreThoseOfTheFastKernel) {
  const bool assumed = GetParam() == ZoneKind::kAssumedStrain;
  const Block block{0, 2, 0, 1, 5, 4};
  const Grid grid = assumed ? make_grid(block) : distorted_grid(block);
  const auto weights = ones(grid);
  NonlinearZones general(GetParam(), grid, kElastic, weights, false);
  ElasticZones fast(GetParam(), grid, plane_strain(kYoung, kPoisson), weights);
  const std::size_t n = grid.x.size();
  std::vector<double> vx(n), vy(n), f1x(n), f1y(n), f2x(n), f2y(n);
  for (std::size_t i = 0; i < n; ++i) {
    vx[i] = std::sin(3.7 * static_cast<double>(i));
    vy[i] = std::cos(5.1 * static_cast<double>(i));
  }
  fast.follow(vx.data(), vy.data());
  general.add_forces(1.0, {vx.data(), vy.data(), f1x.data(), f1y.data()});
  fast.add_forces(1.0, {vx.data(), vy.data(), f2x.data(), f2y.data()});
  double scale = 0;
  for (const double f : f2x) scale = std::max(scale, std::abs(f));
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(f1x[i], f2x[i], 1e-13 * scale);
    EXPECT_NEAR(f1y[i], f2y[i], 1e-13 * scale);
  }
  EXPECT_NEAR(general.strain_energy(), fast.strain_energy(), 1e-13 * fast.strain_energy());
  for (std::size_t z = 0; z < grid.zones.size(); ++z)
    EXPECT_NEAR(general.stress(z).xy, fast.stress(z).xy, 1e-13 * kYoung);
}

// Threads share the sum of the energy, and the stresses: ranges that begin and end anywhere in rows and
// batches make up the whole, and have the stresses of each zone, for every law and elastic zones of equal and
// of many shapes, without what was taken away.
TEST_P(NonlinearZonesOfEachKind, RangesMakeUpTheWhole) {
  for (const bool distorted : {false, true}) {
    const Block block{0, 150, 0, 3, 150, 3};
    const Grid grid = distorted ? distorted_grid(block) : make_grid(block);
    const std::size_t n = grid.x.size(), count = grid.zones.size();
    std::vector<double> vx(n), vy(n), fx(n), fy(n), weights(count);
    for (std::size_t i = 0; i < n; ++i) {
      vx[i] = 1e-3 * std::sin(3.7 * static_cast<double>(i));
      vy[i] = 1e-3 * std::cos(5.1 * static_cast<double>(i));
    }
    for (std::size_t z = 0; z < count; ++z) weights[z] = 0.25 + 0.5 * static_cast<double>(z % 2);
    std::vector<bool> gone(count, false);
    for (std::size_t z = 100; z < 180; ++z) gone[z] = true;
    const auto check = [&](ZoneKernel& zones, const std::string& name) {
      zones.follow(vx.data(), vy.data());
      zones.add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()});
      zones.remove(gone);
      const double whole = zones.strain_energy();
      EXPECT_GT(whole, 0) << name;
      double sum = 0, one_by_one = 0;
      for (const auto& [begin, end] : {protocol::IndexRange{0, 37}, {37, 38}, {38, 130}, {130, 450}})
        sum += zones.strain_energy({begin, end});
      for (std::uint32_t z = 0; z < count; ++z) one_by_one += zones.strain_energy({z, z + 1});
      EXPECT_NEAR(sum, whole, 1e-14 * whole) << name;
      EXPECT_NEAR(one_by_one, whole, 1e-13 * whole) << name;
      EXPECT_EQ(zones.strain_energy({100, 180}), 0) << name;
      PlaneStresses stresses;
      for (const auto& [begin, end] : {protocol::IndexRange{5, 6}, {38, 102}, {170, 181}, {411, 450}}) {
        zones.find_stresses({begin, end}, stresses);
        for (std::uint32_t z = begin; z < end; ++z) {
          const Stress each = zones.stress(z);
          EXPECT_NEAR(stresses.mean[z - begin], (each.xx + each.yy) / 2, 1e-13 * kYoung) << name;
          EXPECT_NEAR(stresses.difference[z - begin], (each.xx - each.yy) / 2, 1e-13 * kYoung) << name;
          EXPECT_NEAR(stresses.shear[z - begin], each.xy, 1e-13 * kYoung) << name;
        }
      }
    };
    ElasticZones elastic(GetParam(), grid, plane_strain(kYoung, kPoisson), weights);
    check(elastic, "elastic");
    for (const auto& [name, material] : laws()) {
      NonlinearZones zones(GetParam(), grid, material, weights, false);
      check(zones, name);
    }
  }
}

// Patch test with a law: uniform strain beyond yield gives the same stress in all zones, and no force inside.
TEST_P(NonlinearZonesOfEachKind, PassThePatchTestBeyondYield) {
  const Grid grid = distorted_grid({-1, 1, 0, 1, 5, 4});
  for (const auto& [name, material] : laws()) {
    NonlinearZones zones(GetParam(), grid, material, ones(grid), false);
    const std::size_t n = grid.x.size();
    std::vector<double> vx(n), vy(n), fx(n), fy(n);
    for (std::size_t i = 0; i < n; ++i) {
      vx[i] = 4e-4 * grid.x[i] + 3e-4 * grid.y[i];
      vy[i] = -5e-4 * grid.y[i] + 1e-4 * grid.x[i];
    }
    for (int step = 0; step < 10; ++step) {
      std::ranges::fill(fx, 0.0);
      std::ranges::fill(fy, 0.0);
      zones.add_forces(0.1, {vx.data(), vy.data(), fx.data(), fy.data()});
    }
    EXPECT_GT(zones.dissipated(), 0) << name;
    for (std::size_t z = 0; z < grid.zones.size(); ++z)
      EXPECT_NEAR(zones.stress(z).xx, zones.stress(0).xx, 1e-4) << name;
    for (std::size_t i = 0; i < n; ++i) {
      if (std::abs(grid.x[i]) == 1 || grid.y[i] == 0 || grid.y[i] == 1) continue;
      EXPECT_NEAR(fx[i], 0, 1e-5) << name;
      EXPECT_NEAR(fy[i], 0, 1e-5) << name;
    }
  }
}

// Shaken far beyond yield with weights, distorted zones, loads and prescribed motions: kinetic + strain +
// dissipated - work keeps its value to 1e-12 of the work, and the dissipated energy never falls.
TEST_P(NonlinearZonesOfEachKind, EnergyLedgerClosesForEveryLaw) {
  for (const auto& [name, material] : laws()) {
    const Grid grid = distorted_grid({0, 4, 0, 1, 8, 3});
    std::vector<double> weights(grid.zones.size());
    for (std::size_t z = 0; z < weights.size(); ++z) weights[z] = 0.05 + 0.04 * static_cast<double>(z % 20);
    auto ground = all_of(grid, material);
    ground.materials.push_back(kElastic);  // and some zones of the fast kernel
    for (std::size_t z = 0; z < grid.zones.size(); z += 5) ground.of_zone[z] = 1;
    ZoneSet zones(GetParam(), grid, ground, weights);
    for (std::size_t z = 0; z < grid.zones.size(); ++z) zones.set_stress(z, {-1e5, -2e5, 3e4});
    std::vector<std::uint32_t> left, right;
    for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
      if (grid.x[i] == 0) left.push_back(i);
      if (grid.x[i] == 4) right.push_back(i);
    }
    const std::vector<double> fx(left.size(), 2e4), fy(left.size(), -1e4);
    Continuum continuum(std::move(zones), lumped_masses(grid, weights, kDensity),
                        {{left, fx, fy, [](double t) { return std::sin(400 * t); }}},
                        {{right, Axis::kX, 0.0, [](double) { return 1.0; }},
                         {right, Axis::kY, 0.6, [](double t) { return std::sin(300 * t); }}});
    const double dt = 0.8 * critical_step(GetParam(), grid, ground);
    Energies first{}, e{};
    continuum.step({0, dt}, &first);
    double peak = 0, drift = 0, dissipated = 0;
    for (std::uint64_t n = 1; n <= 3000; ++n) {
      continuum.step({n, dt}, &e);
      EXPECT_GE(e.dissipated, dissipated) << name;
      dissipated = e.dissipated;
      peak = std::max({peak, e.kinetic, e.strain, std::abs(e.external_work)});
      const double ledger = e.kinetic + e.strain + e.dissipated - e.external_work;
      drift = std::max(drift, std::abs(ledger - (first.kinetic + first.strain - first.external_work)));
    }
    EXPECT_GT(e.dissipated, 0.1 * e.external_work) << name;
    EXPECT_LE(drift, 1e-12 * peak) << name;
  }
}

// Zones that take over the state of others go on with the same bits, for every law, in small and large
// strain.
TEST_P(NonlinearZonesOfEachKind, GoOnFromAStateToTheBit) {
  for (const bool large_strain : {false, true})
    for (const auto& [name, material] : laws()) {
      const Grid grid = distorted_grid({-1, 1, 0, 1, 9, 8});
      const std::size_t n = grid.x.size();
      std::vector<double> vx(n), vy(n), ux(n), uy(n);
      const auto advance = [&](NonlinearZones& zones) {
        std::vector<double> fx(n), fy(n);
        zones.add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()});
        fx.insert(fx.end(), fy.begin(), fy.end());
        return fx;
      };
      const auto shake = [&](int step) {
        for (std::size_t i = 0; i < n; ++i) {
          vx[i] = 3e-5 * std::sin(0.3 * step + grid.y[i]) * (grid.x[i] + 2 * grid.y[i]);
          vy[i] = 3e-5 * std::cos(0.2 * step + grid.x[i]) * (grid.x[i] - grid.y[i]);
          ux[i] += vx[i];
          uy[i] += vy[i];
        }
      };
      const auto make = [&, &material = material] {
        NonlinearZones zones(GetParam(), grid, material, ones(grid), large_strain);
        zones.follow(ux.data(), uy.data());
        return zones;
      };
      NonlinearZones first = make(), second = make();
      for (int step = 0; step < 40; ++step) {
        shake(step);
        advance(first);
      }
      EXPECT_GT(first.dissipated(), 0) << name;
      state::Archive written;
      first.exchange(written);
      state::Archive read(written.take());
      second.exchange(read);
      read.require_end();
      for (int step = 40; step < 80; ++step) {
        shake(step);
        ASSERT_EQ(advance(first), advance(second)) << name << step;
      }
      EXPECT_EQ(first.dissipated(), second.dissipated()) << name;
      EXPECT_EQ(first.field(7, ZoneField::kYieldState), second.field(7, ZoneField::kYieldState)) << name;
    }
}

// Large strain: a stressed grid that is turned as a rigid body through a right angle keeps its stress in its
// own directions, for every law, and elastic too; forces turn with it.
TEST_P(NonlinearZonesOfEachKind, RigidRotationTurnsTheStressAndNothingElse) {
  auto all = laws();
  all.push_back({"elastic", kElastic});
  for (const auto& [name, material] : all) {
    const Grid grid = distorted_grid({-1, 2, 0, 1, 6, 4});
    const std::size_t n = grid.x.size();
    std::vector<double> vx(n), vy(n), fx(n), fy(n), ux(n), uy(n), f0x(n), f0y(n);
    NonlinearZones zones(GetParam(), grid, material, ones(grid), true);
    zones.follow(ux.data(), uy.data());
    const Stress start{-3e5, 1e5, 1.75e5};
    for (std::size_t z = 0; z < grid.zones.size(); ++z) {
      zones.set_stress(z, start);
      zones.set_stress_zz(z, -1.25e5);
    }
    zones.add_forces(1.0, {vx.data(), vy.data(), f0x.data(), f0y.data()});
    const double energy = zones.strain_energy();
    const int steps = 37;
    for (int step = 0; step < steps; ++step) {
      const double next = pi / 2 * (step + 1) / steps;
      for (std::size_t i = 0; i < n; ++i) {  // to the place that the next angle gives
        vx[i] = std::cos(next) * grid.x[i] - std::sin(next) * grid.y[i] - grid.x[i] - ux[i];
        vy[i] = std::sin(next) * grid.x[i] + std::cos(next) * grid.y[i] - grid.y[i] - uy[i];
      }
      std::ranges::fill(fx, 0.0);
      std::ranges::fill(fy, 0.0);
      for (std::size_t i = 0; i < n; ++i) {
        ux[i] += vx[i];
        uy[i] += vy[i];
      }
      zones.add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()});
    }
    for (std::size_t z = 0; z < grid.zones.size(); ++z) {
      EXPECT_NEAR(zones.stress(z).xx, start.yy, 1e-10 * 3e5) << name;
      EXPECT_NEAR(zones.stress(z).yy, start.xx, 1e-10 * 3e5) << name;
      EXPECT_NEAR(zones.stress(z).xy, -start.xy, 1e-10 * 3e5) << name;
      EXPECT_NEAR(zones.field(z, ZoneField::kStressZz), -1.25e5, 1e-10 * 3e5) << name;
    }
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(fx[i], -f0y[i], 1e-10 * 3e5) << name;
      EXPECT_NEAR(fy[i], f0x[i], 1e-10 * 3e5) << name;
    }
    EXPECT_NEAR(zones.strain_energy(), energy, 1e-10 * energy) << name;
    EXPECT_NEAR(zones.dissipated(), 0, 1e-10 * energy) << name;
  }
}

// Large strain: ground that is pressed together along x alone has the same stress along y and across the
// plane, in the directions of the area as it is now.
TEST_P(NonlinearZonesOfEachKind, PressedAlongOneAxisHasEqualStressesAlongTheOthers) {
  const Grid grid = make_grid({0, 2, 0, 1, 4, 2});
  const std::size_t n = grid.x.size();
  std::vector<double> vx(n), vy(n), fx(n), fy(n), ux(n), uy(n);
  NonlinearZones zones(GetParam(), grid, kElastic, ones(grid), true);
  zones.follow(ux.data(), uy.data());
  for (int step = 0; step < 20; ++step) {
    for (std::size_t i = 0; i < n; ++i) ux[i] += vx[i] = -0.01 * grid.x[i];
    zones.add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()});
  }
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    EXPECT_LT(zones.stress(z).yy, -0.1 * kYoung * kPoisson);
    EXPECT_NEAR(zones.field(z, ZoneField::kStressZz), zones.stress(z).yy, -1e-12 * zones.stress(z).yy);
  }
}

// Large strain: a stretched free block that spins three times round and rings keeps its energy, kinetic +
// strain + dissipated, to an error of the second order in the time step (6e-5 of the energy at half the
// critical step), and its angular momentum.
TEST_P(NonlinearZonesOfEachKind, SpinningBlockKeepsItsEnergyToSecondOrder) {
  const double spin = 150, end = 3 * 2 * pi / spin, stretch = 1e-3;
  double coarse = 0;
  for (const double share : {0.5, 0.25, 0.125}) {
    const Grid grid = distorted_grid({-0.5, 0.5, -0.25, 0.25, 6, 4});
    const auto ground = all_of(grid, kElastic, true);
    const auto masses = lumped_masses(grid, ones(grid), kDensity);
    const double dt = share * critical_step(GetParam(), grid, ground);
    Continuum continuum(ZoneSet(GetParam(), grid, ground, ones(grid)), masses, {}, {});
    continuum.step({0, dt});
    const double wave = 2 * pi * 1500;
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
      continuum.vx()[i] = -spin * grid.y[i] + stretch * wave * grid.x[i];
      continuum.vy()[i] = spin * grid.x[i];
    }
    Energies e{}, first{};
    double drift = 0;
    const auto steps = static_cast<std::uint64_t>(end / dt);
    for (std::uint64_t n = 1; n <= steps; ++n) {
      continuum.step({n, dt}, &e);
      if (n == 1) first = e;
      drift = std::max(drift, std::abs(e.kinetic + e.strain - first.kinetic - first.strain));
    }
    const double error = drift / (first.kinetic + first.strain);
    EXPECT_LE(error, 6e-5 * share * share / 0.25) << share;
    if (coarse > 0) {
      EXPECT_GE(std::log2(coarse / error), 1.8) << share;
    }
    coarse = error;
    EXPECT_EQ(e.dissipated, 0);
    double momentum = 0, expected = 0;
    for (std::size_t i = 0; i < masses.size(); ++i) {
      momentum += masses[i] * ((grid.x[i] + continuum.ux()[i]) * continuum.vy()[i] -
                               (grid.y[i] + continuum.uy()[i]) * continuum.vx()[i]);
      expected += masses[i] * (grid.x[i] * spin * grid.x[i] +
                               (spin * grid.y[i] - stretch * wave * grid.x[i]) * grid.y[i]);
    }
    EXPECT_NEAR(momentum, expected, 1e-10 * std::abs(expected));
  }
}

}  // namespace
}  // namespace adit::fdm::test::nonlinear_zones_test
