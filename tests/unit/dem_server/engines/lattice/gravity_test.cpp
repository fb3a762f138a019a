// Requirement: a steady acceleration of all particles moves a lattice as a load on each of them does, in
// statics with local damping, too; its work is that of such a load, and counts from the beginning of time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dem_server/engines/lattice/lattice_engine.hpp"
#include "tests/support/lattice_model.hpp"

namespace adit::dem::gravity_test {
namespace {

constexpr double kRadius = 0.5;

// Stands on its lowest row, which is prescribed.
Model block(bool steady) {
  Model model = test::lattice_in({0, 14, 0, 12}, kRadius, 2.0, {{7e6, 3e6}, 1e12, 1e12});
  const double bottom = std::ranges::min(model.discs.y);
  std::vector<std::uint32_t> lowest;
  for (const std::uint32_t i : model.id)
    if (model.discs.y[i] < bottom + kRadius) lowest.push_back(i);
  model.motions.push_back({Component::kY, lowest, 0.0, [](double) { return 1.0; }, "motions"});
  model.loads.push_back(
      {Load::Kind::kAcceleration, model.id, 1, -10, [](double) { return 1.0; }, "body_loads", steady});
  return model;
}

void step(LatticeEngine& engine, const protocol::Step& step) {
  engine.prepare(true);
  engine.step_interface(step);
  engine.step_interior(step);
}

TEST(Gravity, IsALoadOnAllParticles) {
  LatticeEngine one(block(true), 1), each(block(false), 1);
  const double dt = 0.5 * one.critical_step();
  for (LatticeEngine* engine : {&one, &each}) {
    for (std::uint64_t n = 0; n < 200; ++n)
      step(*engine, {.number = n, .dt = dt, .relax = true, .local_damping = 0.5});
    engine->stop();
    engine->start_over({});
  }
  for (std::uint64_t n = 0; n < 200; ++n) {
    for (LatticeEngine* engine : {&one, &each}) step(*engine, {n, dt});
    const Energies a = one.energies({n, dt}), b = each.energies({n, dt});
    if (n == 0) {
      EXPECT_EQ(a.external_work, 0);
    }
    EXPECT_NEAR(a.external_work, b.external_work, 1e-10 * a.strain);
    EXPECT_NEAR(a.kinetic + a.strain, b.kinetic + b.strain, 1e-10 * a.strain);
  }
  double largest = 0, apart = 0;
  for (std::size_t i = 0; i < one.particles().size(); ++i) {
    largest = std::max(largest, std::abs(one.particles().uy[i]));
    apart = std::max(apart, std::abs(one.particles().uy[i] - each.particles().uy[i]));
  }
  EXPECT_GT(largest, 1e-5);
  EXPECT_LT(apart, 1e-11 * largest);
}

}  // namespace
}  // namespace adit::dem::gravity_test
