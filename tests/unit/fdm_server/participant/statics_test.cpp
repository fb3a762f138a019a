// Requirement: impulses that come with the first step of time correct the last step of statics, whose
// velocities then vanish: the run is the same to the bit as without them (wire.proto, Advance).
#include <gtest/gtest.h>

#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::statics_test {
namespace {

constexpr double kDt = 2e-5;

// A loaded block with a held edge, a driven one and a dashpot's, tied at two points of the latter two.
struct TiedRun {
  Conversation run{
      "edge_loads { where { x_min: 1 x_max: 5 y_min: 1 } force { x: 2e6 y: -3e6 } } "
      "body_loads { acceleration { y: -9.81 } } "
      "motions { where { x_max: 0 } velocity { x: 0 y: 0 } } "
      "motions { where { y_max: 0 x_min: 2 } velocity { y: 0.2 } time { sine { frequency: 300 } } } "
      "damping { rayleigh { ratio: 0.05 low_frequency: 200 high_frequency: 800 } } "
      "histories { name: 'u' quantity: DISPLACEMENT_X at { x: 1 y: 1 } } "
      "histories { name: 's' quantity: STRESS_XX at { x: 4.2 y: 0.4 } }"};
  std::vector<double> impulses;

  TiedRun() {
    wire::Couple couple;
    for (const double value : {2.0, 0.0, 5.9, 0.5}) couple.add_points(value);
    wire::Operator op;
    run.participant.couple(couple, op);
  }
  const wire::Predicted& advance(std::uint64_t step, bool relax) {
    wire::Advance advance;
    advance.set_step(step);
    advance.set_dt(kDt);
    advance.mutable_impulses()->Assign(impulses.begin(), impulses.end());
    advance.set_relax(relax);
    advance.set_want_energies(true);
    advance.set_want_histories(true);
    run.predicted.Clear();
    run.participant.advance(advance, run.predicted);
    impulses.clear();
    for (const double velocity : run.predicted.velocities()) impulses.push_back(-50 * velocity);
    return run.predicted;
  }
};

TEST(Statics, TheirLastCorrectionLeavesNoTraceInTime) {
  TiedRun with, without;
  for (std::uint64_t n = 0; n < 50; ++n)
    for (TiedRun* run : {&with, &without}) run->advance(n, true);
  EXPECT_GT(std::abs(with.impulses[2]), 1) << "the test must see something to correct";
  without.impulses.clear();
  for (std::uint64_t n = 0; n <= 200; ++n)
    ASSERT_EQ(with.advance(n, false).SerializeAsString(), without.advance(n, false).SerializeAsString()) << n;
}

// Rayleigh damping shortens the step of time alone: statics take that of the zones, and time does not.
TEST(Statics, TakeTheStepWithoutRayleighDamping) {
  Conversation undamped(""),
      damped("damping { rayleigh { ratio: 0.2 low_frequency: 1 high_frequency: 50 } }");
  const double of_zones = undamped.model.critical_dt();
  EXPECT_EQ(undamped.model.critical_static_dt(), of_zones);
  EXPECT_EQ(damped.model.critical_static_dt(), of_zones);
  EXPECT_LT(damped.model.critical_dt(), 0.9 * of_zones);
  const auto advance = [&damped, of_zones](bool relax) {
    wire::Advance request;
    request.set_dt(0.99 * of_zones);
    request.set_relax(relax);
    damped.participant.advance(request, damped.predicted);
  };
  EXPECT_NO_THROW(advance(true));
  adit::test::expect_refusal([&] { advance(false); }, "time.dt", "above the continuum's critical step");
}

// Ties that bear the weight of all points let them fall freely no more: they move steadily, and local damping
// takes nothing. Their weight is not what they lack of balance.
TEST(LocalDamping, TakesNothingFromTiedPointsThatMoveSteadily) {
  wire::Weights weights;
  const Conversation alone("");
  weights.mutable_weights()->Resize(alone.model.sample_points_size() / 2, 1.0);
  weights.set_x_min(-1);
  weights.set_x_max(7);
  weights.set_y_min(-1);
  weights.set_y_max(2);
  Conversation run("body_loads { acceleration { y: -10 } } damping { local { alpha: 0.2 } }", weights);
  wire::Couple couple;
  *couple.mutable_points() = run.interface.points();
  wire::Operator op;
  run.participant.couple(couple, op);
  const double dt = 0.5 * run.model.critical_dt();
  double kinetic = 0, taken = 0;  // a few steps after the blow that set the points in motion
  for (std::uint64_t n = 0; n <= 50; ++n) {
    wire::Advance request;
    request.set_step(n);
    request.set_dt(dt);
    request.set_want_energies(true);
    for (int k = 0; n > 0 && k < op.inverse_masses_size(); ++k) {
      const double mass = 1 / op.inverse_masses(k), kick = n == 1 ? dt / 2 : dt;
      request.add_impulses(mass * ((k % 2 == 1 ? 10 * kick : 0) + (n == 1 ? 0.3 : 0)));
    }
    run.predicted.Clear();
    run.participant.advance(request, run.predicted);
    if (n != 5) continue;
    kinetic = run.predicted.energies().kinetic();
    taken = run.predicted.energies().dissipated();
  }
  EXPECT_GT(kinetic, 0.01 * run.interface.mass());
  EXPECT_NEAR(run.predicted.energies().kinetic(), kinetic, 1e-9 * kinetic);
  EXPECT_NEAR(run.predicted.energies().dissipated(), taken, 1e-9 * kinetic);
}

}  // namespace
}  // namespace adit::fdm::test::statics_test
