// Requirement: what both engines can compute, they tell alike: forces of bonds, means over circles, initial
// stress, cracks, weights, the state of a snapshot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "dem_server/engines/general/general_engine.hpp"
#include "dem_server/engines/lattice/lattice_engine.hpp"
#include "dem_server/model/initial_state/initial_state.hpp"
#include "dem_server/model/solid/thin_strip.hpp"
#include "dem_server/observe/branches.hpp"
#include "dem_server/packing/useful_threads.hpp"
#include "dem_server/participant/choose_engine.hpp"
#include "protocol/errors.hpp"
#include "tests/support/lattice_model.hpp"

namespace adit::dem::engines_test {
namespace {

constexpr double kRadius = 0.5;
const ContactBond kBond{7e6, 3e6, 2e5, 2e5};

Model block() {
  return test::lattice_in({0, 14, 0, 12}, kRadius, 2.0, kBond);
}

class Engines : public testing::TestWithParam<bool> {
 protected:
  static std::unique_ptr<LocalEngine> make(const Model& model, std::size_t threads = 1) {
    if (GetParam()) return std::make_unique<LatticeEngine>(model, threads);
    return std::make_unique<GeneralEngine>(model, threads);
  }
  // Particles move with these gradients of velocity for one step, which strains the block by them times dt.
  static void strain(LocalEngine& engine, double xx, double yy, double xy) {
    Particles& p = engine.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.vx[i] = xx * p.x[i] + xy * p.y[i];
      p.vy[i] = xy * p.x[i] + yy * p.y[i];
    }
    engine.step_interface({1, 1.0});
    engine.step_interior({1, 1.0});
  }
};
INSTANTIATE_TEST_SUITE_P(Both, Engines, testing::Bool(),
                         [](const auto& info) { return info.param ? "Lattice" : "General"; });

// As many threads share a step as pay, where none are asked for; else those that are.
TEST_P(Engines, AreSharedByAsManyThreadsAsPay) {
  const Model large = test::lattice_in({0, 110, 0, 100}, kRadius, 2.0, kBond);
  ASSERT_GT(large.discs.size(), 10000u);
  EXPECT_EQ(make(large, 0)->threads(), useful_threads(large.discs.size()));
  EXPECT_EQ(make(block(), 0)->threads(), 1u);
  EXPECT_EQ(make(block(), 3)->threads(), 3u);
}

// Without dissipation nothing tells the direction of time: from the reversed velocities of half a step
// before, a body goes back the way it came. Shear forces are sums of increments, whose frame turns with the
// bond.
TEST_P(Engines, GoBackTheWayTheyCame) {
  Model model = block();
  const auto engine = make(model);
  Particles& p = engine->particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = 1e-3 * std::sin(0.7 * p.x[i] + 0.3 * p.y[i]);
    p.vy[i] = 1e-3 * std::cos(0.4 * p.x[i] - 0.8 * p.y[i]);
    p.spin[i] = 1e-3 * std::sin(p.y[i]);
  }
  const double dt = 0.4 * engine->critical_step();
  const auto step = [&](std::uint64_t n) {
    engine->step_interface({n, dt});
    engine->step_interior({n, dt});
  };
  constexpr std::uint64_t kSteps = 200;
  std::vector<std::vector<double>> way(1);  // x displacements of steps 0, 1, …
  std::vector<double> vx, vy, spin;
  for (std::uint64_t n = 1; n <= kSteps; ++n) {
    vx.assign(p.vx.begin(), p.vx.end());
    vy.assign(p.vy.begin(), p.vy.end());
    spin.assign(p.spin.begin(), p.spin.end());
    step(n);
    way.emplace_back(p.ux.begin(), p.ux.end());
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = -vx[i];
    p.vy[i] = -vy[i];
    p.spin[i] = -spin[i];
  }
  double farthest = 0, apart = 0;
  for (std::uint64_t back = 1; back < kSteps; ++back) {
    step(kSteps + back);
    for (std::size_t i = 0; i < p.size(); ++i) {
      apart = std::max(apart, std::abs(p.ux[i] - way[kSteps - back][i]));
      farthest = std::max(farthest, std::abs(way[kSteps - back][i]));
    }
  }
  EXPECT_GT(farthest, 1e-6) << "the test would not see a motion that differs";
  EXPECT_LT(apart, 1e-6 * farthest);
}

// Under a small uniform strain e a bond of direction n, t bears kn 2R n.e.n and ks 2R t.e.n.
TEST_P(Engines, TellTheForcesOfBonds) {
  const auto engine = make(block());
  const double xx = 1e-7, yy = -2e-7, xy = 3e-7;
  strain(*engine, xx, yy, xy);
  std::size_t bonds = 0;
  engine->for_each_bond([&](const ObservedPair& bond) {
    const double nx = bond.nx, ny = bond.ny;
    const double normal = 7e6 * 2 * kRadius * (xx * nx * nx + 2 * xy * nx * ny + yy * ny * ny);
    const double shear = 3e6 * 2 * kRadius * ((yy - xx) * nx * ny + xy * (nx * nx - ny * ny));
    EXPECT_NEAR(bond.normal, normal, 1e-5);
    EXPECT_NEAR(bond.shear, shear, 1e-5);
    EXPECT_EQ(bond.state, BondState::kIntact);
    ++bonds;
  });
  EXPECT_EQ(bonds, engine->counts().bonds);
  engine->for_each_contact([](const ObservedPair&) { FAIL() << "nothing else touches"; });
}

// The stress in a circle, asked as a history, is that of the solid.
TEST_P(Engines, TakeStressOverACircle) {
  const auto engine = make(block());
  scene::Particles scene;
  for (const auto quantity : {scene::STRESS_XX, scene::STRESS_XY, scene::COORDINATION, scene::POROSITY}) {
    auto& history = *scene.add_histories();
    history.set_quantity(quantity);
    history.set_radius(5);
    history.mutable_at()->set_x(7);
    history.mutable_at()->set_y(6);
  }
  engine->watch(scene);
  engine->prepare(false);
  const double xx = 1e-7, xy = 3e-7;
  strain(*engine, xx, 0, xy);
  std::vector<double> values;
  engine->read_histories({1, 1.0}, values);
  const double root = std::numbers::sqrt3 / 4;
  EXPECT_NEAR(values[0] / (root * (3 * 7e6 + 3e6) * xx), 1, 2e-3);
  EXPECT_NEAR(values[1] / (root * (7e6 + 3e6) * 2 * xy), 1, 2e-3);
  EXPECT_NEAR(values[2], 6, 1e-9);
  EXPECT_NEAR(values[3], 1 - std::numbers::pi / 2 / std::numbers::sqrt3, 5e-3);
}

// Initial stress is in the bonds at the start, balances on every particle inside, and carries the weight that
// it grows by.
TEST_P(Engines, StartUnderInitialStress) {
  Model model = block();
  const double weight = 2.0 / (2 * std::numbers::sqrt3 * kRadius * kRadius) * 10;  // [N/m^3]
  model.loads = {
      {Load::Kind::kAcceleration, model.id, 0, -10, [](double) { return 1.0; }, "body_loads", true}};
  set_initial_state(
      [=](double, double y) {
        return protocol::GroundStress{-3e3 + weight / 2 * y, -5e3 + weight * y, 1e3, {}};
      },
      model);
  const auto engine = make(model);
  engine->step_interface({0, 1e-6});
  engine->step_interior({0, 1e-6});
  const Particles& p = engine->particles();
  std::size_t inside = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.x[i] < 2 || p.x[i] > 12 || p.y[i] < 2 || p.y[i] > 10) continue;
    // From rest each velocity is half a kick.
    EXPECT_NEAR(p.mass[i] * p.vx[i] / 5e-7, 0, 1e-8);
    EXPECT_NEAR(p.mass[i] * p.vy[i] / 5e-7, 0, 1e-8);
    EXPECT_NEAR(p.spin[i], 0, 1e-12);
    ++inside;
  }
  EXPECT_GT(inside, 50u);
  const Circle circle{7, 6, 4};
  const Tensor stress = mean_stress(circle, branches_of(*engine));
  EXPECT_NEAR(stress.xx, -3e3 + weight / 2 * 6, 10);
  EXPECT_NEAR(stress.yy, -5e3 + weight * 6, 10);
  EXPECT_NEAR(stress.xy, 1e3, 10);
}

// A stress at the start is let go at the free surface: both engines see the same motion.
TEST(EnginesUnderInitialStress, MoveAlike) {
  Model model = block();
  set_initial_state([](double, double) { return protocol::GroundStress{-3e3, 1e3, 5e2, {}}; }, model);
  LatticeEngine lattice(model, 1);
  GeneralEngine general(model, 1);
  const double dt = 0.4 * std::min(lattice.critical_step(), general.critical_step());
  for (std::uint64_t n = 0; n < 300; ++n)
    for (LocalEngine* engine : {static_cast<LocalEngine*>(&lattice), static_cast<LocalEngine*>(&general)}) {
      engine->prepare(true);
      engine->step_interface({n, dt});
      engine->step_interior({n, dt});
    }
  std::vector<double> ux(model.discs.size());
  for (std::size_t i = 0; i < ux.size(); ++i) ux[lattice.particles().id[i]] = lattice.particles().ux[i];
  double largest = 0, apart = 0;
  for (std::size_t i = 0; i < ux.size(); ++i) {
    largest = std::max(largest, std::abs(ux[i]));
    apart = std::max(apart, std::abs(general.particles().ux[i] - ux[general.particles().id[i]]));
  }
  EXPECT_GT(largest, 1e-5);
  EXPECT_LT(apart, 1e-3 * largest);
  const double strain = lattice.energies({299, dt}).strain;
  EXPECT_NEAR(general.energies({299, dt}).strain, strain, 1e-3 * strain);
}

// Both engines compute a model from the same velocities up: how far apart they end.
struct Apart {
  std::size_t cracks[2] = {0, 0};              // lattice, general
  double displacement = 0, strain_energy = 0;  // shares of the largest, of the lattice's
};
Apart pluck(const Model& model, std::uint64_t steps) {
  LatticeEngine lattice(model, 1);
  GeneralEngine general(model, 1);
  LocalEngine* const engines[2] = {&lattice, &general};
  const double dt = 0.4 * std::min(lattice.critical_step(), general.critical_step());
  Apart apart;
  for (int k = 0; k < 2; ++k) {
    Particles& p = engines[k]->particles();
    for (std::size_t i = 0; i < p.size(); ++i) p.vy[i] = 12 * std::cos(std::numbers::pi * p.x[i] / 10);
    for (std::uint64_t n = 1; n <= steps; ++n) {
      engines[k]->prepare(true);
      engines[k]->step_interface({n, dt});
      engines[k]->step_interior({n, dt});
      apart.cracks[k] += engines[k]->broken().size();
    }
  }
  std::vector<double> uy(model.discs.size());
  for (std::size_t i = 0; i < uy.size(); ++i) uy[lattice.particles().id[i]] = lattice.particles().uy[i];
  double largest = 0;
  for (std::size_t i = 0; i < uy.size(); ++i) {
    const double other = uy[general.particles().id[i]];
    largest = std::max(largest, std::abs(other));
    apart.displacement = std::max(apart.displacement, std::abs(general.particles().uy[i] - other));
  }
  apart.displacement /= largest;
  const double strain = lattice.energies({steps, dt}).strain;
  apart.strain_energy = std::abs(general.energies({steps, dt}).strain / strain - 1);
  return apart;
}

Model strip(const ContactBond& law) {
  Model model = test::lattice_in({0, 20, 0, 5 * std::numbers::sqrt3 * kRadius}, kRadius, 2.0, law);
  stiffen_outer_rows(model);
  return model;
}

TEST(EnginesOfAThinStrip, MoveAlike) {
  const Apart apart = pluck(strip({kBond.stiffness}), 2000);
  EXPECT_LT(apart.displacement, 1e-3);
  EXPECT_LT(apart.strain_energy, 1e-3);
}

// What a stiffer bond leaves is a stiffer contact, in both engines.
TEST(EnginesOfAThinStrip, BreakAlike) {
  const Apart apart = pluck(strip({kBond.stiffness, 8e4, 8e4}), 1000);
  EXPECT_GT(apart.cracks[0], 0u);
  EXPECT_EQ(apart.cracks[0], apart.cracks[1]);
  EXPECT_LT(apart.displacement, 1e-3);
  EXPECT_LT(apart.strain_energy, 1e-3);
}

// A bond that breaks is told with the place where its particles touched, its mode and its particles' places
// in the packing; what was under pressure stays pressed.
TEST_P(Engines, TellCracksByTheirPlaces) {
  Model model = test::lattice_in({0, 4, 0, 0.9}, kRadius, 2.0, kBond);
  ASSERT_EQ(model.bonds.size(), 3u);
  const auto engine = make(model);
  Particles& p = engine->particles();
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.id[i] == 3) p.vx[i] = 0.1;
  engine->step_interface({1, 1.0});
  engine->step_interior({1, 1.0});
  ASSERT_EQ(engine->broken().size(), 1u);
  const Crack crack = engine->broken()[0];
  EXPECT_EQ(crack.mode, BondState::kTensileCrack);
  EXPECT_DOUBLE_EQ(crack.x, 3);
  EXPECT_DOUBLE_EQ(crack.y, model.discs.y[0]);
  EXPECT_DOUBLE_EQ(crack.length, 2 * kRadius / std::numbers::sqrt3);
  EXPECT_DOUBLE_EQ(crack.orientation, std::numbers::pi / 2);
  EXPECT_EQ(crack.parent_a, 2u);
  EXPECT_EQ(crack.parent_b, 3u);
  EXPECT_EQ(engine->fragments(), 2u);
  engine->step_interface({2, 1e-9});
  engine->step_interior({2, 1e-9});
  EXPECT_TRUE(engine->broken().empty());
}

// The weights of a model are those of what computes it: masses by the discs', forces by the bonds', neither
// below the floor; the places in the packing stay.
TEST_P(Engines, KeepTheWeightsAboveTheFloor) {
  const Model whole = block();
  std::vector<double> centres, midpoints;
  for (const double x : whole.discs.x) centres.push_back(std::clamp((x - 3) / 6, 0.0, 1.0));
  for (const Bond& bond : whole.bonds)
    midpoints.push_back(
        std::clamp(((whole.discs.x[bond.first] + whole.discs.x[bond.second]) / 2 - 3) / 6, 0.0, 1.0));
  const double floor = 0.2;
  const auto engine = make(weigh(whole, {centres, midpoints, floor}));
  const Particles& p = engine->particles();
  EXPECT_LT(p.size(), whole.discs.size());
  std::vector<double> sum(p.size(), 0), count(p.size(), 0);
  double least = 1;
  engine->for_each_bond([&](const ObservedPair& bond) {
    EXPECT_GE(bond.weight, floor);
    least = std::min(least, bond.weight);
    for (const std::uint32_t i : {bond.first, bond.second}) sum[i] += bond.weight, count[i] += 1;
  });
  EXPECT_EQ(least, floor);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_EQ(p.x[i], whole.discs.x[p.id[i]]);
    EXPECT_NEAR(p.weight[i], sum[i] / count[i], 1e-15);
    EXPECT_DOUBLE_EQ(p.mass[i], 2 * p.weight[i]);
    EXPECT_DOUBLE_EQ(p.inertia[i], p.mass[i] * kRadius * kRadius / 2);
  }
}

}  // namespace
}  // namespace adit::dem::engines_test
