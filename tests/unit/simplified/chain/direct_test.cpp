// The Riccati sweep against general sparse integration of the same equations.
#include "tests/support/chain/direct_integration.hpp"

#include <gtest/gtest.h>

#include "tests/support/chain/sweep_cost.hpp"
#include "tests/unit/simplified/chain/chains.hpp"

namespace adit::simplified::chain::direct_test {
namespace {

// The largest difference of any displacement over `steps` steps, against the largest displacement so far.
double worst_difference(const Chain& chain, const Settings& settings, long steps) {
  const std::size_t n = chain.bodies.size();
  Simulation sweep(chain, settings);
  test::DirectIntegration direct(chain, settings);
  test::Wave wave(n);
  double worst = 0, largest = 0;
  for (long step = 1; step <= steps; ++step) {
    const Excitation excitation = wave.at(step * settings.dt);
    sweep.step(excitation);
    direct.step(excitation);
    const BodyMotion motion = sweep.bodies();
    const double* other = direct.displacement().data();
    double difference = 0;
    for (std::size_t i = 0; i < n; ++i, other += 3) {
      largest = std::max({largest, std::abs(other[0]), std::abs(other[1])});
      difference = std::max({difference, std::abs(motion.x[i] - other[0]), std::abs(motion.y[i] - other[1]),
                             chain.bodies[i].length * std::abs(motion.rotation[i] - other[2])});
    }
    if (largest > 0) worst = std::max(worst, difference / largest);
  }
  EXPECT_GT(largest, 0.01);
  return worst;
}

// 264 winding segments on soil springs, fixed at one end, agree to 1e-10 over 10,000 steps.
TEST(RiccatiAgainstDirect, ImmersedTunnel) {
  EXPECT_LT(worst_difference(test::winding(264), {.dt = 0.005}, 10000), 1e-10);
}

// 4,667 rings in varying ground agree to 1e-10 over 3,000 steps.
TEST(RiccatiAgainstDirect, BoredTunnel) {
  EXPECT_LT(worst_difference(test::rings(4667), {.dt = 0.005}, 3000), 1e-10);
}

// So they do with other parameters of the integration, with two abutments, at block borders and for a single
// body.
TEST(RiccatiAgainstDirect, EverySize) {
  for (const std::size_t n : {1, 2, 127, 128, 129, 257}) {
    Chain chain = test::winding(n);
    chain.finish = test::joint();
    EXPECT_LT(worst_difference(chain, {.dt = 0.005, .newmark = {0.3025, 0.6}}, 500), 1e-11) << n << " bodies";
  }
}

}  // namespace
}  // namespace adit::simplified::chain::direct_test
