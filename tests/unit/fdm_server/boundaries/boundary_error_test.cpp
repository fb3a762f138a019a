// Every error in what the scene says of boundaries, base and damping: the field's path and what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/boundaries/boundary_scenes.hpp"

namespace adit::fdm::test::boundary_error_test {
namespace {

using testing::HasSubstr;

using Case = adit::test::RefusedText;
class BoundaryError : public testing::TestWithParam<Case> {};

TEST_P(BoundaryError, NamesTheFieldAndTheRemedy) {
  const Case& refused = GetParam();
  adit::test::expect_refusal(
      [&] {
        GroundRun("block { x_min: 0 x_max: 4 y_min: -3 y_max: 0 zones_x: 4 zones_y: 3 } " + refused.text, 1);
      },
      refused.path, refused.message);
}

std::string base(const std::string& rest) {
  return "base { acceleration { ricker { frequency: 5 time: 0.3 } } " + rest + " } ";
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, BoundaryError,
    testing::Values(
        Case{"quiet_nowhere", "quiet { where { y_min: 1 } }", "continuum.quiet[0].where",
             "holds no whole edge of the continuum's boundary"},
        Case{"quiet_inside", "quiet { where { x_min: 0.5 x_max: 3.5 y_min: -2.5 y_max: -0.5 } }",
             "continuum.quiet[0].where", "widen it"},
        Case{"quiet_without_dashpots", "quiet { where { y_max: -3 } normal: false shear: false }",
             "continuum.quiet[0]", "leave one of them true"},
        Case{"quiet_twice", "quiet { where { x_max: 0 } } quiet { where { x_max: 2 y_min: -1 } }",
             "continuum.quiet[1].where", "as continuum.quiet[0] does; an edge has one condition"},
        Case{"quiet_and_base", base("where { y_max: -3 }") + "quiet { where { y_max: -3 } }",
             "continuum.base.where",
             "the boundary edge from (0, -3) to (1, -3) m, as continuum.quiet[0] does"},
        Case{"quiet_and_free_field", "free_field { left: true } quiet { where { x_max: 0 } }",
             "continuum.quiet[0].where", "as continuum.free_field does"},
        Case{"base_nowhere", base("where { y_max: -9 }"), "continuum.base.where", "holds no whole edge"},
        Case{"base_without_motion", "base { kind: COMPLIANT }", "continuum.base",
             "has no motion; give one of acceleration, velocity, stress"},
        Case{"motion_without_source", "base { acceleration { peak: 2 } }", "continuum.base.acceleration",
             "give one of file, ricker"},
        Case{"stress_of_a_rigid_base", "base { stress { amplitude: 1e4 } }", "continuum.base.stress",
             "or `kind: compliant`"},
        Case{"incidence_of_a_velocity",
             "base { velocity { amplitude: 1 } incidence { apparent_velocity: 500 } }",
             "continuum.base.incidence", "goes with `acceleration` only"},
        Case{"table_of_a_velocity",
             "base { velocity { amplitude: 1 time { table { time: 0 time: 1 value: 0 } } } }",
             "continuum.base.velocity.time.table.value", "has 1 elements, expected 2, as many as `time`"},
        Case{"no_frequency", "base { acceleration { ricker { frequency: 0 time: 0.3 } } }",
             "continuum.base.acceleration.ricker.frequency", "is 0 Hz, expected a frequency above 0 Hz"},
        Case{"negative_frequency", "base { acceleration { sine { frequency: -2 end: 0.3 } } }",
             "continuum.base.acceleration.sine.frequency", "is -2 Hz, expected a frequency above 0 Hz"},
        Case{"corner_above_nyquist",
             "base { acceleration { ricker { frequency: 5 time: 0.3 } high_corner: 800 } }",
             "continuum.base.acceleration", "at steps of 0.001 s give one below 500 Hz"},
        Case{"taper_longer_than_the_motion",
             "base { acceleration { ricker { frequency: 5 time: 0.3 } taper: 0.7 } }",
             "continuum.base.acceleration", "taper"},
        Case{"record_too_short",
             "base { acceleration { file { path: 'a.csv' content: 'time_s,a_m/s^2\\n0,0\\n0.5,1\\n' } } }",
             "continuum.base.acceleration.file.path", "the motion a.csv lasts 0.5 s, but 1 s are asked for"},
        Case{"record_of_no_kind", "base { acceleration { file { path: 'kobe.txt' content: '1 2' } } }",
             "continuum.base.acceleration.file.path",
             "or state `time_step` and `unit` of a file of values only"},
        Case{"record_of_a_wrong_header",
             "base { acceleration { file { path: 'kobe.AT2' content: 'x\\ny\\nIN UNITS OF G\\nNPTS= 9, DT= "
             ".02 "
             "SEC\\n.1 .2\\n' } } }",
             "continuum.base.acceleration.file.path", "states 9 points, but 2 values follow"},
        Case{"drift", base("incidence { coherency { drift: -1 } }"),
             "continuum.base.incidence.coherency.drift", "is -1 s/m, expected"},
        Case{"base_and_motions", base("") + "motions { where { x_max: 0 } velocity { x: 0 } }",
             "continuum.base",
             "prescribes the x velocity of the grid point (0, -3) m, as one of `motions` does"},
        Case{"held_compliant_base",
             base("kind: COMPLIANT") + "motions { where { y_max: -3 } velocity { x: 0 } }", "continuum.base",
             "absorbs nothing along x between (0, -3) and (1, -3) m"},
        Case{"held_quiet_side",
             "quiet { where { x_max: 0 } } motions { where { x_max: 0 } velocity { x: 0 } }",
             "continuum.quiet[0]", "absorbs nothing along x"},
        Case{"held_shear_dashpots",
             "quiet { where { y_max: -3 } normal: false } motions { where { y_max: -3 } velocity { x: 0 } }",
             "continuum.quiet[0]", "absorbs nothing along x"},
        Case{"held_free_field", "free_field { left: true } motions { where { x_max: 0 } velocity { x: 0 } }",
             "continuum.free_field", "leave the motion away (after statics: `motions: []`)"},
        Case{"damping_of_no_kind", "damping {}", "continuum.damping",
             "give `rayleigh`, `maxwell` or `local`"},
        Case{"negative_ratio", "damping { rayleigh { ratio: -0.1 low_frequency: 1 high_frequency: 5 } }",
             "continuum.damping.rayleigh.ratio", "is -0.1, expected a pure number above 0 and below 1"},
        Case{"no_damping_frequency", "damping { rayleigh { ratio: 0.1 low_frequency: 0 high_frequency: 5 } }",
             "continuum.damping.rayleigh.low_frequency", "is 0 Hz, expected a frequency above 0 Hz"},
        Case{"band_too_wide", "damping { maxwell { ratio: 0.05 low_frequency: 0.1 high_frequency: 20 } }",
             "continuum.damping.maxwell.high_frequency",
             "is 200 times low_frequency, but three elements keep the ratio over a band of at most 100"},
        Case{"frequencies_exchanged",
             "damping { rayleigh { ratio: 0.1 low_frequency: 5 high_frequency: 1 } }",
             "continuum.damping.rayleigh.high_frequency",
             "is 1 Hz, expected a frequency of at least `low_frequency` = 5 Hz"}),
    adit::test::kRefusalName);

// What is held beside the dashpots, or across them, or everywhere, for waves in one dimension, leaves them
// what they absorb.
TEST(BoundaryErrors, MotionsBesideDashpotsAreNone) {
  for (const std::string& boundaries :
       {base("kind: COMPLIANT") + "motions { where { y_max: -3 } velocity { y: 0 } }",
        std::string("quiet { where { x_max: 0 } } motions { where { y_max: -3 } velocity { x: 0 y: 0 } }"),
        std::string("quiet { where { y_max: -3 } } motions { velocity { y: 0 } where { } }")})
    EXPECT_NO_THROW(
        GroundRun("block { x_min: 0 x_max: 4 y_min: -3 y_max: 0 zones_x: 4 zones_y: 3 } " + boundaries, 1))
        << boundaries;
}

// A side that zones vanished from has no free field.
TEST(BoundaryErrors, SideOfAFreeFieldIsInterrupted) {
  GroundRun run(
      "block { x_min: 0 x_max: 4 y_min: -3 y_max: 0 zones_x: 4 zones_y: 3 } free_field { right: true }", 1);
  wire::Weights weights;
  for (int i = 0; i < run.model.sample_points_size(); i += 2)
    weights.add_weights(run.model.sample_points(i) >= 3 && run.model.sample_points(i + 1) <= -1 &&
                                run.model.sample_points(i + 1) >= -2
                            ? 0
                            : 1);
  weights.set_floor(1e-3);
  wire::Setup setup;
  *setup.mutable_scene() = run.scene;
  FdmParticipant participant;
  participant.set_up(setup, run.model);
  adit::test::expect_refusal([&] { participant.weigh(weights, run.interface); }, "continuum.free_field.right",
                             "one vertical line, but it is interrupted at (4, -2) m");
}

}  // namespace
}  // namespace adit::fdm::test::boundary_error_test
