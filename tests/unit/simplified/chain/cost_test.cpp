// What a step costs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <new>

#include "tests/support/chain/sweep_cost.hpp"
#include "tests/unit/simplified/chain/chains.hpp"

namespace {
long allocations = 0;
}
// Not inlined: GCC would see one of a pair without the other and warn of it.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace adit::simplified::chain::cost_test {
namespace {

// No step allocates memory, with curves or without.
TEST(Cost, NoAllocationInTheStep) {
  for (const bool curved : {false, true}) {
    Chain chain = test::winding(100);
    if (curved) {
      for (Hinge& hinge : chain.hinges) {
        hinge.axial.stiffness = 0;
        hinge.axial.curve = {{-0.01, 0, 0.001}, {-1e8, -1e7, 0}};
      }
    }
    Simulation run(chain, {.dt = 0.01});
    test::Wave wave(100);
    const long before = allocations;
    for (int step = 1; step <= 200; ++step) run.step(wave.at(0.01 * step));
    EXPECT_EQ(allocations, before);
  }
}

// The cost of a body and step does not grow with their number, but for what caches do: at 50,000 bodies it
// stays within ten times that at 500 (a quadratic method would show a hundred), the same motion as the direct
// solver's.
TEST(Cost, LinearInTheNumberOfBodies) {
  const test::SweepCost small = test::sweep_cost(500, 400), large = test::sweep_cost(50000, 8);
  EXPECT_LT(large.sweep_ns(), 10 * small.sweep_ns());
  EXPECT_LT(small.relative_difference, 1e-10);
  EXPECT_LT(large.relative_difference, 1e-10);
}

// Decay far ahead of a wave into the smallest numbers costs nothing: a chain whose first body alone is loaded
// is as fast, within a factor 3, as one in full motion.
TEST(Cost, SmallestNumbersAreNotSlow) {
  const std::size_t n = 4000;
  const auto seconds = [n](const std::vector<double>& load) {
    Simulation run(test::rings(n), {.dt = 0.005});
    double best = 1e9;
    for (int round = 0; round < 10; ++round) {
      const std::clock_t begin = std::clock();
      for (int step = 0; step < 10; ++step) run.step({.load_y = load});
      best = std::min(best, static_cast<double>(std::clock() - begin));
    }
    return best;
  };
  std::vector<double> one(n);
  one[0] = 1e6;
  EXPECT_LT(seconds(one), 3 * seconds(std::vector<double>(n, 1e6)));
}

}  // namespace
}  // namespace adit::simplified::chain::cost_test
