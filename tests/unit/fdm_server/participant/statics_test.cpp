// Requirement: impulses that come with the first step of time correct the last step of statics, whose
// velocities then vanish: the run is the same to the bit as without them (wire.proto, Advance).
#include <gtest/gtest.h>

#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test {
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

}  // namespace
}  // namespace adit::fdm::test
