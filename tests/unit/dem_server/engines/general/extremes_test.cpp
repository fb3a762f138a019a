// Extremes that a run must survive, or refuse by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "protocol/errors.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::extremes_test {
namespace {

// One particle has a critical step, and falls as it should.
TEST(DiscsExtremes, OneParticle) {
  auto scene = test::placed_scene("x_m,y_m,radius_m\n1,2,0.1\n");
  scene.mutable_particles()->add_body_loads()->mutable_acceleration()->set_y(-10);
  test::InProcessRun run(scene);
  ASSERT_TRUE(std::isfinite(run.dt) && run.dt > 0);
  run.advance();
  const double start = run.sum();
  for (int n = 1; n <= 1000; ++n) run.advance();
  const double t = 1000 * run.dt;
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  EXPECT_NEAR(snapshot.pieces(0).point_fields(0).values(1), -5 * t * t, 1e-12 * t * t);
  EXPECT_NEAR(run.sum(), start, 1e-12 * run.predicted.energies().external_work());
}

TEST(DiscsExtremes, TwoAtOnePointAreRefused) {
  const auto scene = test::placed_scene("x_m,y_m,radius_m\n0,0,0.1\n3,1,0.1\n0.5,0,0.1\n3,1,0.2\n");
  adit::test::expect_refusal([&] { test::InProcessRun run(scene); }, "particles.placed.path",
                             "1 and 3 (counted from 0) both lie at (3, 1) m");
}

// A stress that no forces can give is refused by name: shear of a square packing without shear stiffness, any
// stress of a single row, and one beside the stress under which discs were packed.
TEST(DiscsExtremes, InitialStressThatIsNotResistedIsRefused) {
  const auto refuse = [](scene::Scene scene, const std::string& path, const std::string& text) {
    scene.mutable_initial_stress()->set_yy(-1e6);
    scene.mutable_initial_stress()->set_xy(1e5);
    adit::test::expect_refusal([&] { test::InProcessRun run(scene); }, path, text);
  };
  auto square = test::square_scene(3, 3);
  square.mutable_particles()->mutable_bonds()->set_shear_stiffness(0);
  refuse(square, "initial_stress", "which the particles do not resist");
  refuse(test::square_scene(3, 1), "initial_stress", "no area lies between the particles");
  auto random = test::random_scene();
  random.mutable_particles()->mutable_random_packing()->set_keep_stress(true);
  refuse(random, "particles.random_packing.keep_stress", "is set, but initial_stress");
}

// A step far above the critical one ends with the step and the place where it went wrong.
TEST(DiscsExtremes, InstabilityIsNamed) {
  auto scene = test::square_scene(6, 6);
  auto& push = *scene.mutable_particles()->add_body_loads();
  push.mutable_where()->set_x_max(2);
  push.mutable_acceleration()->set_x(1);
  test::InProcessRun run(scene, {}, 5);
  try {
    for (int n = 0; n < 5000; ++n) run.advance();
    FAIL();
  } catch (const protocol::Unstable& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("step "));
    EXPECT_THAT(error.what(), testing::HasSubstr("reduce time.dt_factor"));
  }
}

// A large disc in the midst of small ones, 1:50: all pairs that may touch are listed, and the ledger closes.
TEST(DiscsExtremes, SizesOneToFifty) {
  std::vector<std::array<double, 3>> discs = {{0, 0, 1}};
  for (int ring = 0; ring < 2; ++ring)
    for (int k = 0; k < 150; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5 * ring) / 150, r = 1.021 + 0.045 * ring;
      discs.push_back({r * std::cos(angle), r * std::sin(angle), 0.02});
    }
  const Model model = test::loose_discs(discs, {1e8, 5e7, 0.5});
  test::Run run(model, 0.2 * critical_step(model));
  Particles& p = run.solver.particles();
  for (std::size_t i = 1; i < p.size(); ++i) {
    p.vx[i] = -2 * p.x[i] + 0.5 * p.y[i];
    p.vy[i] = -2 * p.y[i] - 0.3 * p.x[i];
  }
  run.step();
  const double start = run.kinetic();
  for (int n = 0; n < 2000; ++n) {
    run.step();
    const DiscLedger ledger = run.solver.ledger();
    ASSERT_NEAR(run.kinetic() + run.solver.strain_energy().sum() + ledger.friction +
                    run.solver.time_step_share(run.solver.strain_energy().sum()),
                start, 1e-9 * start);
    if (n % 100 != 0) continue;
    std::set<std::pair<std::uint32_t, std::uint32_t>> listed;
    const Pairs& pairs = run.solver.contacts();
    for (std::size_t k = 0; k < pairs.size(); ++k) listed.insert({pairs.first[k], pairs.second[k]});
    for (std::uint32_t i = 0; i < p.size(); ++i)
      for (std::uint32_t j = i + 1; j < p.size(); ++j)
        if (std::hypot(p.x[j] + p.ux[j] - p.x[i] - p.ux[i], p.y[j] + p.uy[j] - p.y[i] - p.uy[i]) <
            p.radius[i] + p.radius[j]) {
          ASSERT_TRUE(listed.contains({i, j})) << i << ' ' << j << " at step " << n;
        }
  }
  EXPECT_GT(run.solver.ledger().friction, 0);
  EXPECT_GT(run.solver.neighbours().lists(), 2u);
  EXPECT_LT(run.solver.neighbours().lists(), 1000u) << "only when needed";
  EXPECT_LT(std::abs(run.solver.time_step_share(run.solver.strain_energy().sum())), 1e-2 * start);
}

// Soft and stiff bonds, a million to one: stable at the critical step itself.
TEST(DiscsExtremes, StiffnessContrastOfAMillion) {
  std::vector<std::array<double, 3>> discs;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column)
      discs.push_back({0.2 * column + (row % 2) * 0.1, 0.1 * std::sqrt(3) * row, 0.1});
  Model model = test::loose_discs(discs, {0, 0, 0});
  model.contact_bonds = {{1e12, 3e11}, {1e6, 3e5}};
  test::join(model, Bond::Law::kContactBond);
  for (std::size_t k = 0; k < model.bonds.size(); k += 2) model.bonds[k].number = 1;
  test::Run run(model, critical_step(model));
  Particles& p = run.solver.particles();
  for (std::size_t i = 0; i < p.size(); ++i) p.vx[i] = 1e-3 * std::sin(7.0 * static_cast<double>(i));
  run.step();
  const auto sum = [&run] {
    return run.kinetic() + run.solver.strain_energy().sum() +
           run.solver.time_step_share(run.solver.strain_energy().sum());
  };
  const double start = sum();
  double most = 0;
  for (int n = 0; n < 20000; ++n) {
    run.step();
    most = std::max(most, run.solver.strain_energy().sum());
  }
  EXPECT_LT(most, 100 * start);
  EXPECT_NEAR(sum(), start, 1e-9 * most);
}

// All bonds break in one step: every disc flies off alone, and no energy is lost sight of.
TEST(DiscsExtremes, AllBondsBreakAtOnce) {
  std::vector<std::array<double, 3>> discs;
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 40; ++column) discs.push_back({0.2 * column, 0.2 * row, 0.1});
  Model model = test::loose_discs(discs, {1e8, 1e8, 0.5});
  model.parallel_bonds = {{1e9, 4e8, 0.1, 1e3, 1e3, 0.5}};
  test::join(model, Bond::Law::kParallelBond);
  for (const std::size_t threads : {1u, 2u}) {
    test::Run run(model, 0.5 * critical_step(model), threads);
    Particles& p = run.solver.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.vx[i] = 3 * (p.x[i] - 4);
      p.vy[i] = 3 * (p.y[i] - 4);
    }
    run.step();
    EXPECT_EQ(run.solver.broken().size(), model.bonds.size());
    double start = 0;
    for (int n = 0; n < 500; ++n) {
      run.step();
      const double sum = run.kinetic() + run.solver.strain_energy().sum() + run.solver.ledger().friction +
                         run.solver.ledger().released +
                         run.solver.time_step_share(run.solver.strain_energy().sum());
      if (n == 0) start = sum;
      ASSERT_NEAR(sum, start, 1e-9 * start);
    }
    EXPECT_EQ(run.solver.strain_energy().sum(), 0);
  }
}

// A disc that flies off to infinity disturbs no other, however far it is.
TEST(DiscsExtremes, ParticlesLeaveToInfinity) {
  Model model = test::loose_discs({{0, 0, 0.1}, {0.25, 0, 0.1}, {5, 5, 0.1}}, {1e8, 0, 0});
  test::Run run(model, 0.02 * critical_step(model));
  Particles& p = run.solver.particles();
  p.vx = {1, -1, 1e9};
  p.vy = {0, 0, -1e12};
  run.steps(10000);
  EXPECT_GT(std::abs(p.uy[2]), 1e9);
  EXPECT_NEAR(p.vx[0], -1, 1e-3) << "the others collided";
  EXPECT_NEAR(p.vx[1], 1, 1e-3);
}

// Cracks, places and velocities are the same to the last bit for 1, 2 and 4 threads.
TEST(DiscsExtremes, ThreadsChangeNothing) {
  std::vector<std::array<double, 3>> discs;
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 60; ++column)
      discs.push_back(
          {0.2 * column + (row % 2) * 0.1, 0.1 * std::sqrt(3) * row, (row + column) % 7 ? 0.1 : 0.095});
  const LinearContact contact{5e8, 2e8, 0.4, 0.1, 0.1};
  Model model = test::loose_discs(discs, contact);
  model.parallel_bonds = {{1e10, 4e9, 0.1, 2e5, 1e6, 0.5}};
  for (const Pair& pair : pairs_within(model.discs, 0.012))
    model.bonds.push_back({pair.first, pair.second, Bond::Law::kParallelBond, 0});
  model.walls = {
      test::wall(-1, -0.1, 13, -0.1, contact),
      test::wall(-1, 0.1 * std::sqrt(3) * 59 + 0.1, 13, 0.1 * std::sqrt(3) * 59 + 0.1, contact, 0, -5)};
  model.local_damping = 0.1;
  std::vector<std::tuple<std::uint64_t, std::uint32_t>> cracks[3];
  std::vector<double> state[3];
  const std::size_t threads[] = {1, 2, 4};
  for (int k = 0; k < 3; ++k) {
    test::Run run(model, 0.5 * critical_step(model), threads[k]);
    for (int n = 0; n < 400; ++n) {
      run.step();
      for (const std::uint32_t bond : run.solver.broken()) cracks[k].emplace_back(run.next, bond);
    }
    const Particles& p = run.solver.particles();
    for (const auto* column : {&p.ux, &p.uy, &p.vx, &p.vy, &p.spin})
      state[k].insert(state[k].end(), column->begin(), column->end());
    const DiscLedger ledger = run.solver.ledger();
    for (const double value : {ledger.pairs, ledger.friction, ledger.released, ledger.damping.local})
      state[k].push_back(value);
  }
  EXPECT_GT(cracks[0].size(), 30u);
  for (int k : {1, 2}) {
    EXPECT_EQ(cracks[k], cracks[0]);
    EXPECT_EQ(state[k], state[0]);
  }
}

}  // namespace
}  // namespace adit::dem::extremes_test
