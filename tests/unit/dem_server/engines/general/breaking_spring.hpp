// Two discs that part until the spring between them breaks.
#pragma once

#include <gtest/gtest.h>

#include "tests/unit/dem_server/discs_models.hpp"

namespace adit::dem::test {

// The sum of all energies stays while the second disc moves away at 0.6 m/s and the only spring breaks.
inline void expect_energy_while_the_spring_breaks(Run& run) {
  run.solver.particles().vx[1] = 0.6;
  const auto sum = [&run] {
    return run.kinetic() + run.solver.strain_energy().sum() + run.solver.ledger().released +
           run.solver.time_step_share(run.solver.strain_energy().sum());
  };
  run.step();
  const double start = sum();
  while (run.solver.springs().broken().empty() && run.next < 100000) run.step();
  ASSERT_EQ(run.solver.springs().broken().size(), 1u);
  EXPECT_NEAR(sum(), start, 1e-9 * start);
}

}  // namespace adit::dem::test
