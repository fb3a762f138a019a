// Requirements on springs with curves, clearance and direction: gaskets and keys.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "dem_server/engines/general/forces/spring_forces.hpp"
#include "dem_server/engines/general/general_engine.hpp"
#include "protocol/springs/force_curve.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/engines/general/breaking_spring.hpp"
#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::springs_test {
namespace {

using protocol::ForceCurve;

// A gasket pressed by 2 kN when it is installed; it stiffens in compression and lets go at 4 mm.
const std::vector<double> kOpening{-2e-3, 0, 4e-3, 6e-3}, kForce{-10e3, -2e3, 0, 0};

Model two_discs(double distance) {
  return test::loose_discs({{0, 0, 0.1}, {distance, 0, 0.1}}, {0, 0, 0});
}

double pull(const Model& model, double stretch) {
  Solver solver(model, 1);
  PrescribedMotions none;
  solver.particles().vx[1] = stretch;
  solver.step({1, 1.0}, test::no_loads, none);
  EXPECT_DOUBLE_EQ(solver.particles().fx[0], -solver.particles().fx[1]);
  return solver.particles().fx[0];
}

TEST(Springs, FollowACurveBeyondTheirClearance) {
  Model gasket = two_discs(1);
  gasket.springs = {{0, 1, 4e6, false, 0, 1e9}};
  gasket.springs[0].curve = std::make_shared<ForceCurve>(kOpening, kForce);
  for (const auto& [stretch, force] : {std::pair{0.0, -2e3}, {-1e-3, -6e3}, {2e-3, -1e3}, {5e-3, 0.0}})
    EXPECT_NEAR(pull(gasket, stretch), force, 1e-6);
  Model key = two_discs(1);
  key.springs = {{0, 1, 1e6, false, 0, 1e9}};
  key.springs[0].clearance = 1e-3;
  for (const auto& [stretch, force] : {std::pair{9e-4, 0.0}, {-9e-4, 0.0}, {3e-3, 2e3}, {-3e-3, -2e3}})
    EXPECT_NEAR(pull(key, stretch), force, 1e-6);
}

// A bolt is gone, with its force, as soon as one of its discs is taken away.
TEST(Springs, GoWithTheirDiscs) {
  Model model = two_discs(1);
  model.springs = {{0, 1, 1e6, false, 5e3, 1e9}};
  Solver solver(model, 1);
  SpringForces springs(model.springs);
  springs.begin_stage(0, 1, solver.particles());
  EXPECT_EQ(springs.forces()[0], 5e3);
  solver.particles().mass[1] = 0;
  springs.begin_stage(1, 2, solver.particles());
  EXPECT_EQ(springs.forces()[0], 0);
  EXPECT_EQ(springs.strain_energy(), 0);
  springs.add_forces(0, solver.particles());
  EXPECT_EQ(solver.particles().fx[0], 0);
}

// Discs that fly apart and come back on a gasket keep their energy: on a slope the trapezoid of a step is
// exact, so that the time step's share grows only by steps h over the corner, each by at most the change of
// slope times h^2 / 8.
TEST(Springs, BookTheEnergyOfTheirCurve) {
  Model model = two_discs(1);
  model.springs = {{0, 1, 4e6, false, 0, 1e9}};
  model.springs[0].curve =
      std::make_shared<ForceCurve>(std::vector{-2e-3, 0.0, 4e-3}, std::vector{-10e3, -2e3, 5e3});
  const double change = 4e6 - 7e3 / 4e-3;
  test::Run run(model, 0.02 * critical_step(model));
  run.solver.particles().vx[1] = 0.5;
  const auto sum = [&run] {
    return run.kinetic() + run.solver.strain_energy().sum() +
           run.solver.time_step_share(run.solver.strain_energy().sum());
  };
  run.step();
  const double start = sum();
  double share = run.solver.time_step_share(run.solver.strain_energy().sum());
  int corners = 0;
  for (int n = 0; n < 2000; ++n) {
    const double before = run.solver.springs().openings()[0];
    run.step();
    const double now = run.solver.springs().openings()[0];
    const bool over_corner = (before < 0) != (now < 0);
    corners += over_corner;
    const double allowed = over_corner ? change * (now - before) * (now - before) / 8 : 0;
    ASSERT_LE(std::abs(run.solver.time_step_share(run.solver.strain_energy().sum()) - share),
              allowed + 1e-12 * start);
    ASSERT_NEAR(sum(), start, 1e-10 * start);
    share = run.solver.time_step_share(run.solver.strain_energy().sum());
  }
  EXPECT_GT(corners, 4);
}

// One that breaks gives up what it held, to rounding of the ledger.
TEST(Springs, ReleaseTheEnergyOfTheirCurve) {
  Model model = two_discs(1);
  model.springs = {{0, 1, 4e6, false, 0, 2e3}};
  model.springs[0].curve =
      std::make_shared<ForceCurve>(std::vector{0.0, 1e-3, 2e-3}, std::vector{0.0, 1e3, 5e3});
  test::Run run(model, 0.002 * critical_step(model));
  test::expect_energy_while_the_spring_breaks(run);
  const double held = 1e3 * 1e-3 / 2 + (1e3 + 2e3) / 2 * 0.25e-3;  // at 2 kN, 1.25 mm
  EXPECT_NEAR(run.solver.ledger().released, held, 0.02 * held);
}

// A key across a joint: it acts along its direction only, and keeps momentum, angular momentum and energy
// while the discs spin.
TEST(Springs, OfADirectionKeepMomenta) {
  Model model = test::loose_discs({{0, 0, 0.1}, {0.25, 0.05, 0.15}}, {0, 0, 0});
  model.springs = {{0, 1, 1e6, false, 0, 1e9}};
  model.springs[0].direction = PlaneVector{0, 1};
  test::Run run(model, 0.05 * critical_step(model));
  Particles& p = run.solver.particles();
  p.vx = {0.1, -0.05};
  p.vy = {0.3, -0.1};
  p.spin = {2, -1};
  const auto angular = [&p] {
    double sum = 0;
    for (int i = 0; i < 2; ++i)
      sum += p.mass[i] * ((p.x[i] + p.ux[i]) * p.vy[i] - (p.y[i] + p.uy[i]) * p.vx[i]) +
             p.inertia[i] * p.spin[i];
    return sum;
  };
  const double linear = p.mass[0] * p.vy[0] + p.mass[1] * p.vy[1], turning = angular();
  const double along_x = p.vx[0];
  run.step();
  const double start = run.kinetic() + run.solver.strain_energy().sum();
  double largest = 0;
  for (int n = 0; n < 400; ++n) {
    run.step();
    largest = std::max(largest, std::abs(run.solver.springs().forces()[0]));
    EXPECT_NEAR(angular(), turning, 1e-12 * std::abs(turning) + 1e-12);
    EXPECT_NEAR(run.kinetic() + run.solver.strain_energy().sum() +
                    run.solver.time_step_share(run.solver.strain_energy().sum()),
                start, 1e-10 * start);
  }
  EXPECT_EQ(p.vx[0], along_x);
  EXPECT_NEAR(p.mass[0] * p.vy[0] + p.mass[1] * p.vy[1], linear, 1e-12 * std::abs(linear));
  EXPECT_GT(largest, 1e3);
  EXPECT_LT(std::abs(run.solver.time_step_share(run.solver.strain_energy().sum())), 1e-2 * start);
}

// The critical step covers the steepest slope: two discs on a spring vibrate at sqrt(2 k / m).
TEST(Springs, CriticalStepCoversTheSteepestSlope) {
  Model model = two_discs(1);
  model.springs = {{0, 1, 4e6, false, 0, 1e9}};
  EXPECT_LE(critical_step(model), 2 / std::sqrt(2 * 4e6 / model.mass[0]) * (1 + 1e-12));
  const double along = critical_step(model);
  model.springs[0].direction = PlaneVector{0, 1};
  EXPECT_LT(critical_step(model), along) << "it turns the discs, too";
  test::Run run(model, 0.999 * critical_step(model));
  run.solver.particles().vy[1] = 1e-3;
  run.solver.particles().spin[0] = 1e-3;
  run.steps(2000);
  EXPECT_LT(std::abs(run.solver.particles().vy[1]), 1) << "stable";
}

scene::Scene scene_of_springs() {
  auto scene = test::square_scene(4, 2);
  auto& spring = *scene.mutable_particles()->add_springs();
  spring.set_name("gasket");
  test::set(*spring.mutable_from(), 1.5, 0.5);
  test::set(*spring.mutable_to(), 2.5, 0.5);
  for (const double opening : kOpening) spring.mutable_curve()->add_opening(opening);
  for (const double force : kForce) spring.mutable_curve()->add_force(force);
  auto& history = *scene.mutable_particles()->add_histories();
  history.set_name("gasket");
  history.set_quantity(scene::SPRING_FORCE);
  history.set_spring("gasket");
  return scene;
}

TEST(Springs, HaveHistoriesAndTellWhichBroke) {
  auto scene = scene_of_springs();
  test::InProcessRun run(scene);
  EXPECT_EQ(run.advance().histories(0), -2e3);
  auto& spring = *scene.mutable_particles()->mutable_springs(0);
  spring.clear_curve();
  spring.set_stiffness(1e6);
  spring.set_pretension(1e3);
  spring.set_strength(500);
  test::InProcessRun other(scene);
  other.advance();
  wire::Bye bye;
  other.participant.finish(bye);
  ASSERT_EQ(bye.figures_size(), 4);
  EXPECT_EQ(bye.figures(0).name(), "springs_broken");
  EXPECT_EQ(bye.figures(0).value(), 1);
  EXPECT_EQ(bye.figures(2).value(), 2);
  EXPECT_EQ(bye.figures(3).value(), 0.5);
}

using Case = adit::test::Refusal<std::function<void(scene::Particles&)>>;
class SpringErrors : public testing::TestWithParam<Case> {};

TEST_P(SpringErrors, NameTheFieldAndTheRemedy) {
  auto scene = scene_of_springs();
  GetParam().input(*scene.mutable_particles());
  adit::test::expect_refusal([&] { test::InProcessRun run(scene); }, "particles." + GetParam().path,
                             GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, SpringErrors,
    testing::Values(Case{"NoLaw", "springs[0].stiffness", "is missing; give it, or a `curve`",
                         [](auto& s) { s.mutable_springs(0)->clear_curve(); }},
                    Case{"TwoLaws", "springs[0].stiffness", "is given beside `curve`",
                         [](auto& s) { s.mutable_springs(0)->set_stiffness(1e6); }},
                    Case{"TensionOnly", "springs[0].tension_only", "is given beside `curve`",
                         [](auto& s) { s.mutable_springs(0)->set_tension_only(true); }},
                    Case{"Pretension", "springs[0].pretension", "is given beside `curve`",
                         [](auto& s) { s.mutable_springs(0)->set_pretension(5); }},
                    Case{"Level", "springs[0].curve.force", "is the same at every opening",
                         [](auto& s) {
                           for (int k = 0; k < 4; ++k) s.mutable_springs(0)->mutable_curve()->set_force(k, 7);
                         }},
                    Case{"PressedWithClearance", "springs[0].clearance", "bears -2000 N at opening 0",
                         [](auto& s) { s.mutable_springs(0)->set_clearance(1e-3); }},
                    Case{"NoDirection", "springs[0].direction", "has no length",
                         [](auto& s) { test::set(*s.mutable_springs(0)->mutable_direction(), 0, 0); }},
                    Case{"TwoOfOneName", "springs[1].name", "is `gasket`, like that of an earlier spring",
                         [](auto& s) { *s.add_springs() = s.springs(0); }},
                    Case{"NoSuchSpring", "histories[0].spring",
                         "is `bolt`, but spring_force is the force of a spring; choose one of gasket",
                         [](auto& s) { s.mutable_histories(0)->set_spring("bolt"); }}),
    adit::test::kRefusalName);

}  // namespace
}  // namespace adit::dem::springs_test
