// A random packing in its box: the walls bear its stress from the first step on where that is kept, nothing
// where not.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "dem_server/engines/general/critical_step.hpp"
#include "dem_server/engines/general/solver.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::kept_stress_test {
namespace {

constexpr double kStiffness = 1e10, kStress = 1e7;  // [N/m], [Pa]
constexpr double kWidth = 2, kHeight = 1;

scene::Scene boxed_scene(bool keep_stress) {
  auto scene = test::random_scene();
  auto& p = *scene.mutable_particles();
  p.mutable_random_packing()->set_stress(kStress);
  p.mutable_random_packing()->set_keep_stress(keep_stress);
  p.mutable_contacts()->set_normal_stiffness(kStiffness);
  p.mutable_contacts()->set_shear_stiffness(0.5 * kStiffness);
  p.mutable_damping()->set_local(0.7);
  const auto add = [&p](const std::string& name, double x_1, double y_1, double x_2, double y_2) {
    auto& wall = *p.add_walls();
    wall.set_name(name);
    test::set(*wall.mutable_from(), x_1, y_1);
    test::set(*wall.mutable_to(), x_2, y_2);
  };
  add("left", 0, 0, 0, kHeight);
  add("right", kWidth, 0, kWidth, kHeight);
  add("lower", 0, 0, kWidth, 0);
  add("upper", 0, kHeight, kWidth, kHeight);
  return scene;
}

// Mean stress on the walls, compression positive [Pa], and the largest speed [m/s], after some steps.
struct State {
  double across, up, fastest;
};

State after(int steps, bool keep_stress) {
  const Model model = read_model(boxed_scene(keep_stress));
  Solver solver(model, 1);
  const double dt = 0.5 * critical_step(model);
  Loads loads;
  PrescribedMotions motions;
  for (int n = 0; n < steps; ++n) solver.step({static_cast<std::uint64_t>(n), dt}, loads, motions);
  const auto& walls = solver.walls();
  State state{(walls.force(1).x - walls.force(0).x) / (2 * kHeight),
              (walls.force(3).y - walls.force(2).y) / (2 * kWidth), 0};
  const Particles& p = solver.particles();
  for (std::size_t i = 0; i < p.size(); ++i)
    state.fastest = std::max(state.fastest, std::hypot(p.vx[i], p.vy[i]));
  return state;
}

// The stress reached is within 1 % of that wanted, alike in both directions, and stays; a packing that were
// let go would move at stress over impedance.
TEST(KeptStress, StandsOnTheWalls) {
  for (const int steps : {1, 2000}) {
    const State state = after(steps, true);
    EXPECT_NEAR((state.across + state.up) / 2, kStress, 0.01 * kStress) << steps;
    EXPECT_NEAR(state.across, state.up, 0.1 * kStress) << steps;
  }
  EXPECT_LT(after(2000, true).fastest, 1e-3 * kStress / std::sqrt(test::kDensity * kStiffness));
}

// But for the rounding of gaps.
TEST(KeptStress, IsGoneWhereItIsNotKept) {
  const State state = after(200, false);
  EXPECT_LT(std::abs(state.across) + std::abs(state.up), 1e-12 * kStress);
  EXPECT_LT(state.fastest, 1e-9);
}

}  // namespace
}  // namespace adit::dem::kept_stress_test
