// Requirements on zones that change, or come into being, in later stages.
#include "fdm_server/model/grid/zone_stages.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::zone_stages_test {
namespace {

const std::string kHole = "where { x_min: 2 x_max: 4 y_min: 0.25 y_max: 0.75 } ";  // 8 of 48 zones
const std::string kLight = "material { young_modulus: 1e9 poisson_ratio: 0.2 density: 1000 } ";

std::string excavation(int stage, const std::string& where = kHole) {
  return fmt::format("excavations {{ {} stage: {} }} ", where, stage);
}
std::string fill(int stage, const std::string& where = kHole, const std::string& material = kLight) {
  return fmt::format("materials {{ {} {} stage: {} }} ", where, material, stage);
}

wire::Setup in_statics(const std::string& conditions) {
  wire::Setup setup = setup_of(conditions);
  setup.mutable_scene()->mutable_statics();
  return setup;
}

// A participant in statics, whose stages the test calls.
struct Statics {
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  wire::Predicted predicted;
  std::uint64_t number = 0;

  explicit Statics(const wire::Setup& setup) {
    set_up(participant, setup, model);
    participant.weigh({}, interface);
  }
  // Zones as they are drawn after two steps of the stage, the second of which moves.
  wire::Piece begin(std::uint32_t stage) {
    for (const bool stop : {true, false}) {
      wire::Advance advance;
      advance.set_step(number++);
      advance.set_dt(model.critical_static_dt() / 2);
      advance.set_relax(true);
      advance.set_stop(stop);
      advance.set_stage(stage);
      predicted.Clear();
      participant.advance(advance, predicted);
      participant.complete();
    }
    wire::Snapshot snapshot;
    participant.snapshot({}, snapshot);
    return snapshot.pieces(0);
  }
};

std::vector<double> field(const wire::Piece& piece, const std::string& name) {
  for (const wire::Field& field : piece.cell_fields())
    if (field.name() == name) return {field.values().begin(), field.values().end()};
  ADD_FAILURE() << "no field " << name;
  return {};
}

int materials_of(const wire::Piece& piece, double number) {
  const auto all = field(piece, "material");
  return static_cast<int>(std::ranges::count(all, number));
}

// Requirement: zones are drawn while they are there, with the material that they have then; they may go and
// come more than once, and in one stage excavations come first.
TEST(ZoneStages, ZonesGoChangeAndComeStageByStage) {
  Statics run(in_statics(excavation(2) + excavation(5) + excavation(6) + fill(1, "where { x_max: 3 } ") +
                         fill(3) + fill(6, "where { x_min: 3 x_max: 4 y_min: 0.25 y_max: 0.75 } ")));
  EXPECT_EQ(materials_of(run.begin(0), 0), 48);
  EXPECT_EQ(materials_of(run.begin(1), 1), 24);
  EXPECT_EQ(field(run.begin(2), "material").size(), 40u);
  const auto filled = run.begin(3);
  EXPECT_EQ(materials_of(filled, 0), 20);
  EXPECT_EQ(materials_of(filled, 1), 20);
  EXPECT_EQ(materials_of(filled, 2), 8);
  EXPECT_EQ(field(run.begin(5), "material").size(), 40u);
  EXPECT_EQ(materials_of(run.begin(6), 3), 4);
  EXPECT_EQ(run.interface.zones(), 48u);
}

// Requirement: an excavation of stage 0 leaves out what no later stage fills; what one fills is there from
// that stage on, as an embankment is.
TEST(ZoneStages, FillsPlacesThatWereNeverGround) {
  Statics run(
      in_statics(excavation(0, "where { y_min: 0.5 } ") + fill(2, "where { y_min: 0.5 y_max: 0.75 } ")));
  EXPECT_EQ(run.interface.zones(), 36u);
  EXPECT_EQ(field(run.begin(0), "material").size(), 24u);
  EXPECT_EQ(field(run.begin(1), "material").size(), 24u);
  EXPECT_EQ(materials_of(run.begin(2), 1), 12);
}

// Requirement: the step of time is that of the last stage's materials, the step of statics the smallest of
// all stages.
TEST(ZoneStages, TheCriticalStepIsThatOfTheStage) {
  const std::string heavy = "material { young_modulus: 25e9 poisson_ratio: 0.2 density: 10000 } ",
                    stiff = "material { young_modulus: 100e9 poisson_ratio: 0.2 density: 2500 } ";
  const std::string all = "where {} ";
  const double first = Statics(in_statics("")).model.critical_dt();
  const wire::Model later = Statics(in_statics(fill(1, all, stiff) + fill(2, all, heavy))).model;
  EXPECT_NEAR(later.critical_dt() / first, 2, 1e-12);
  EXPECT_NEAR(later.critical_static_dt() / first, 0.5, 1e-12);
  EXPECT_NEAR(later.s_wave_speed() / Statics(in_statics("")).model.s_wave_speed(), 0.5, 1e-12);
}

void expect_refused(const wire::Setup& setup, const std::string& path, const std::string& message,
                    const wire::Weights& weights = {}) {
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  adit::test::expect_refusal(
      [&] {
        set_up(participant, setup, model);
        participant.weigh(weights, interface);
      },
      "continuum." + path, message);
}

TEST(ZoneStages, ErrorsNameTheFieldAndTheRemedy) {
  expect_refused(setup_of(fill(1)), "materials[0].stage", "the scene has no statics; give");
  expect_refused(in_statics(fill(1, "where { x_min: 7 } ")), "materials[0].where", "selects no zones");
  expect_refused(in_statics(fill(1, "where { group: 'hole' } ")), "materials[0].where.group",
                 "the continuum has no groups");
  expect_refused(in_statics(fill(2) + excavation(1, "where {} ")), "excavations", "leave no zone");
  expect_refused(in_statics(fill(2) + "quiet { where { x_max: 0 } } " + fill(3, "where { x_max: 1 } ")),
                 "materials[1].stage",
                 "is 3, but the zone at (0.25, 0.125) m, beside dashpots of a boundary");
  expect_refused(in_statics(fill(1) + "foundations { where {} y { stiffness: 1e6 } }"), "foundations",
                 "beside materials of later stages");
  expect_refused(
      in_statics(fill(1) +
                 "interfaces { name: 'i' along { line { points { x: 3 y: 0 } points { x: 3 y: 1 } } } "
                 "law { friction_angle: 0.5 } }"),
      "materials[0].stage", "at an interface, keeps its material");
  wire::Setup large = setup_of(fill(1) + "large_strain: true", kBlock,
                               "material { young_modulus: 25e9 poisson_ratio: 0.2 density: 2500 } ");
  large.mutable_scene()->mutable_statics();
  expect_refused(large, "materials[0].stage", "in small strain only");
}

// Requirement: the coupler knows masses and weights where models overlap: zones there keep their material.
TEST(ZoneStages, ZonesOfAnOverlapKeepTheirMaterial) {
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  participant.set_up(in_statics(fill(1)), model);
  participant.weigh({}, interface);
  wire::Couple couple;
  couple.add_points(1.7);
  couple.add_points(0.4);
  wire::Operator op;
  adit::test::expect_refusal([&] { participant.couple(couple, op); }, "continuum.materials[0].stage",
                             "is 1, but the zone at (2.25, 0.375) m, which the overlap ties");
}

}  // namespace
}  // namespace adit::fdm::test::zone_stages_test
