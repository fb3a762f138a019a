// Requirements on zones that are taken away.
#include "fdm_server/model/grid/excavation.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numeric>

#include "fdm_server/model/grid/read_grid.hpp"
#include "protocol/errors.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::excavation_test {
namespace {

using testing::HasSubstr;

const std::string kHole = "excavations { where { x_min: 2 x_max: 4 y_min: 0.25 y_max: 0.75 } ";

// Requirement: zones of stage 0 never were there, and what they lay bare can be loaded: the hole's four
// sides.
TEST(Excavation, OfStageZeroLaysABoundaryBare) {
  const Grid grid = read_grid(setup_of(kHole + "}").scene().continuum());
  EXPECT_EQ(grid.zones.size(), 48u - 8);
  EXPECT_EQ(grid.x.size(), 65u - 3);
  EXPECT_EQ(grid.boundary.size(), 32u + 12);
  const Conversation run(
      kHole + "} edge_loads { where { x_min: 1.9 x_max: 4.1 y_min: 0.2 y_max: 0.8 } force { x: 1 } }");
  EXPECT_EQ(run.interface.zones(), 40u);
}

// Requirement: zones that were taken away are updated no more: 40 of 48 after the excavation.
TEST(Excavation, ZonesThatAreGoneAreNotUpdated) {
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  wire::Setup setup = setup_of(kHole + "stage: 1 }");
  setup.mutable_scene()->mutable_statics();
  participant.set_up(setup, model);
  participant.weigh({}, interface);
  wire::Predicted predicted;
  for (std::uint64_t n = 0; n <= 4; ++n) {
    wire::Advance advance;
    advance.set_step(n);
    advance.set_dt(model.critical_dt() / 2);
    advance.set_relax(true);
    advance.set_stop(n == 0 || n == 3);
    advance.set_stage(n < 3 ? 0 : 1);
    predicted.Clear();
    participant.advance(advance, predicted);
    participant.complete();
  }
  wire::Bye bye;
  participant.finish(bye);
  EXPECT_EQ(bye.updates(), 48u * 2 + 40u);  // steps 0 and 3 begin from rest and move nothing
}

// A participant in statics, whose stages of excavation the test calls.
struct Statics {
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  wire::Predicted predicted;

  explicit Statics(const wire::Setup& setup) {
    participant.set_up(setup, model);
    participant.weigh({}, interface);
  }
  void step(std::uint64_t number, std::uint32_t stage) {
    wire::Advance advance;
    advance.set_step(number);
    advance.set_dt(model.critical_dt() / 2);
    advance.set_relax(true);
    advance.set_stop(true);
    advance.set_stage(stage);
    predicted.Clear();
    participant.advance(advance, predicted);
  }
  wire::Piece zones() {
    wire::Snapshot snapshot;
    participant.snapshot({}, snapshot);
    return snapshot.pieces(0);
  }
};

// Requirement: a later stage takes mass, stress and weight away; what is left of a body load is the weight of
// what is left; points inside the hole are held and points around it are not.
TEST(Excavation, OfALaterStageTakesWeightAway) {
  wire::Setup setup = setup_of(kHole +
                               "stage: 2 } body_loads { acceleration { y: -10 } } "
                               "motions { where { x_max: 0 } velocity { x: 0 y: 0 } }");
  setup.mutable_scene()->mutable_statics();
  setup.mutable_scene()->mutable_initial_stress()->set_xx(-1e3);
  Statics run(setup);
  run.step(0, 0);
  run.step(1, 1);
  EXPECT_EQ(run.zones().connectivity_size(), 4 * 48);
  const double before = run.predicted.relaxation().internal_force();
  run.step(2, 2);
  EXPECT_EQ(run.zones().connectivity_size(), 4 * 40);
  run.step(3, 2);
  // stresses of 1 kPa everywhere, the gravity of two steps is nothing beside it
  EXPECT_NEAR(run.predicted.relaxation().internal_force() / before, 40.0 / 48, 1e-3);
  const auto piece = run.zones();
  for (int i = 0; 2 * i < piece.points_size(); ++i) {
    const double x = piece.points(2 * i), y = piece.points(2 * i + 1),
                 vy = piece.point_fields(1).values(3 * i + 1);
    const bool held = x == 0 || (x > 2 && x < 4 && y == 0.5);
    EXPECT_EQ(vy == 0, held) << x << ", " << y;
    if (held || (x > 1.4 && x < 4.6)) continue;
    EXPECT_NEAR(vy, -10 * run.model.critical_dt() / 4, 1e-3 * run.model.critical_dt());
  }
}

// Requirement: a zone that two stages name goes with the earlier one, in whichever order they are given.
TEST(Excavation, AZoneGoesWithTheFirstStageThatNamesIt) {
  for (const auto& [left, right] : {std::pair{4, 7}, {7, 4}}) {
    wire::Setup setup = setup_of(
        fmt::format("excavations {{ where {{ x_min: 1 x_max: 3 y_min: 0.25 y_max: 0.75 }} stage: {} }} "
                    "excavations {{ where {{ x_min: 2 x_max: 4.5 y_min: 0.25 y_max: 0.75 }} stage: {} }} ",
                    left, right));
    setup.mutable_scene()->mutable_statics();
    Statics run(setup);
    const int in_left = 8, in_right = 10, in_both = 4;
    std::uint64_t number = 0;
    for (const std::uint32_t stage : {0u, 3u, 4u, 6u, 7u}) {
      run.step(number++, stage);
      const int gone = stage < 4    ? 0
                       : stage == 7 ? in_left + in_right - in_both
                       : left == 4  ? in_left
                                    : in_right;
      EXPECT_EQ(run.zones().connectivity_size(), 4 * (48 - gone)) << "stage " << stage;
    }
  }
}

void expect_refused(const std::string& excavations, bool statics, const std::string& path,
                    const std::string& message) {
  wire::Setup setup = setup_of(excavations);
  if (statics) setup.mutable_scene()->mutable_statics();
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  adit::test::expect_refusal(
      [&] {
        set_up(participant, setup, model);
        participant.weigh({}, interface);
      },
      "continuum." + path, message);
}

TEST(Excavation, ErrorsNameTheFieldAndTheRemedy) {
  expect_refused(kHole + "stage: 1 }", false, "excavations[0].stage", "the scene has no statics; give");
  expect_refused("excavations { where { x_min: 7 } }", false, "excavations[0].where", "selects no zones");
  expect_refused(kHole + "} excavations { where { group: 'hole' } stage: 1 }", true,
                 "excavations[1].where.group", "the continuum has no groups");
  expect_refused("excavations { where {} }", false, "excavations", "leave no zone");
  expect_refused("excavations { where {} stage: 1 }", true, "excavations", "leave no zone");
}

// Requirement: the interface's masses are known to the coupler: its zones stay.
TEST(Excavation, DoesNotReachTheInterface) {
  wire::Setup setup = setup_of(kHole + "stage: 1 }");
  setup.mutable_scene()->mutable_statics();
  for (const double x : {1.7, 1.2}) {
    FdmParticipant participant;
    wire::Model model;
    wire::Interface interface;
    participant.set_up(setup, model);
    participant.weigh({}, interface);
    wire::Couple couple;
    couple.add_points(x);
    couple.add_points(0.4);
    wire::Operator op;
    if (x == 1.2) {
      EXPECT_NO_THROW(participant.couple(couple, op));
      continue;
    }
    adit::test::expect_refusal([&] { participant.couple(couple, op); }, "continuum.excavations",
                               "(2.25, 0.375) m in stage 1");
  }
}

}  // namespace
}  // namespace adit::fdm::test::excavation_test
