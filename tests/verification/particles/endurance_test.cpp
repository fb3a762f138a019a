// Requirement: ten million steps of a few discs leave the energy ledger closed and the motion bounded.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/dem_server/discs_models.hpp"

namespace adit::dem::endurance_test {
namespace {

// A bonded pair that turns and swings, and a loose disc that bounces between two walls and slides on a third.
TEST(DiscsEndurance, TenMillionSteps) {
  const LinearContact contact{1e8, 5e7, 0.3};
  Model model = test::loose_discs({{0, 0, 0.1}, {0.2, 0, 0.1}, {1, 0, 0.1}}, contact);
  model.parallel_bonds = {{1e9, 4e8, 0.1, INFINITY, INFINITY, 0}};
  test::join(model, Bond::Law::kParallelBond);
  model.walls = {test::wall(0.6, -5, 0.6, 5, {1e8, 0, 0}), test::wall(2, -5, 2, 5, {1e8, 0, 0})};
  test::Run run(model, 0.2 * critical_step(model));
  Particles& p = run.solver.particles();
  p.vy = {-1, 1, 0};
  p.vx = {0, 0.1, 1};
  p.spin = {10, 10, 3};
  const auto sum = [&run] {
    const DiscLedger ledger = run.solver.ledger();
    return run.kinetic() + run.solver.strain_energy().sum() + ledger.friction +
           run.solver.time_step_share(run.solver.strain_energy().sum());
  };
  run.step();
  const double start = sum();
  for (int n = 0; n < 10000; ++n) {
    run.steps(1000);
    ASSERT_NEAR(sum(), start, 1e-8 * start);
    ASSERT_LT(std::abs(run.solver.time_step_share(run.solver.strain_energy().sum())), 0.02 * start);
  }
}

}  // namespace
}  // namespace adit::dem::endurance_test
