// Requirements on the participant: what it answers to each request of a run.
#include "fdm_server/participant/participant.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "protocol/errors.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::participant_test {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;

constexpr double kDt = 2e-5;

wire::Weights ramp(const wire::Model& model, double begin, double end) {
  wire::Weights weights;
  for (int i = 0; i < model.sample_points_size(); i += 2)
    weights.add_weights(std::clamp((end - model.sample_points(i)) / (end - begin), 0.0, 1.0));
  weights.set_floor(1e-3);
  return weights;
}

// The model names its box, a positive critical step and a sample point at every half zone.
TEST(Participant, DescribesItsModel) {
  Conversation run("");
  EXPECT_EQ(run.model.x_max(), 6);
  EXPECT_EQ(run.model.y_max(), 1);
  EXPECT_EQ(run.model.sample_points_size(), 2 * 25 * 9);
  EXPECT_GT(run.model.critical_dt(), kDt);
  EXPECT_EQ(run.interface.zones(), 48u);
  EXPECT_EQ(run.interface.grid_points(), 65u);
  EXPECT_EQ(run.interface.points_size(), 0);
}

// Waves run as the plane's elastic constants say, in the fastest material that a zone is made of.
TEST(Participant, ReportsTheWaveSpeedsOfItsZones) {
  const Conversation plain("");
  EXPECT_NEAR(plain.model.p_wave_speed(), std::sqrt(25e9 / (1 - 0.2 * 0.2) / 2500), 1e-9);  // plane stress
  EXPECT_NEAR(plain.model.s_wave_speed(), std::sqrt(25e9 / (2 * 1.2) / 2500), 1e-9);
  const auto with_area = [](const std::string& box) {
    return Conversation("materials { where { " + box +
                        " } material { young_modulus: 1e11 poisson_ratio: 0.2 density: 2500 } }")
        .model.p_wave_speed();
  };
  EXPECT_NEAR(with_area("x_max: 1"), 2 * plain.model.p_wave_speed(), 1e-9);
}

// Zones behind the overlap do not exist, and an overlap may cut through zones, if it leaves more than a
// sliver.
TEST(Participant, RemovesZonesWithoutWeight) {
  const Conversation whole("");
  Conversation run("", ramp(whole.model, 2, 4.2));
  EXPECT_EQ(run.interface.zones(), 36u);  // the zones of [4, 4.5] m have samples with weight at x = 4 m
  EXPECT_EQ(run.interface.grid_points(), 50u);
}

// A weight that grows to the right, as the inner side of an interface gets it, leaves the zones at the right:
// those without any weight vanish, those that the overlap's edge cuts have the mean of the ramp over them.
TEST(Participant, WeightsOfAnInnerRoleKeepTheOtherSide) {
  const Conversation whole("");
  wire::Weights weights;
  for (int i = 0; i < whole.model.sample_points_size(); i += 2)
    weights.add_weights(std::clamp((whole.model.sample_points(i) - 2) / 2, 0.0, 1.0));
  weights.set_floor(1e-3);
  Conversation run("", weights);
  EXPECT_EQ(run.interface.zones(), 32u);
  EXPECT_EQ(run.interface.grid_points(), 45u);
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  const auto& piece = snapshot.pieces(0);
  for (int zone = 0; zone < 32; ++zone) {
    const double left = piece.points(2 * static_cast<int>(piece.connectivity(4 * zone)));
    EXPECT_GE(left, 2);
    EXPECT_NEAR(piece.cell_fields(1).values(zone), std::min((left + 0.25 - 2) / 2, 1.0), 1e-15);
  }
}

// The grid points that exist inside or on the box are offered; without weights there is no interface.
TEST(Participant, OffersGridPointsInsideTheBox) {
  const Conversation whole("");
  wire::Weights weights = ramp(whole.model, 2, 4);
  weights.set_x_min(2);
  weights.set_x_max(4.5);
  weights.set_y_min(0.2);
  weights.set_y_max(0.75);
  Conversation run("", weights);
  ASSERT_EQ(run.interface.points_size(), 2 * 5 * 3);  // x = 2 … 4 m; nothing is left at 4.5 m
  EXPECT_EQ(run.interface.points(0), 2);
  EXPECT_EQ(run.interface.points(1), 0.25);
  wire::Couple couple;
  *couple.mutable_points() = run.interface.points();
  wire::Operator op;
  run.participant.couple(couple, op);
  EXPECT_THAT(op.values(), ElementsAreArray(std::vector<double>(15, 1.0)));
  EXPECT_EQ(op.inverse_masses_size(), 30);
}

// A load on a free body gives the momentum of half a kick at step 0, and its centre moves as a point mass.
TEST(Participant, FreeBodyMovesLikeAPointMass) {
  Conversation run(
      "edge_loads { where { x_max: 0 } force { x: 3e4 } } body_loads { acceleration { y: -10 } } "
      "histories { name: 'u' quantity: DISPLACEMENT_Y at { x: 0 y: 0.5 } } "
      "histories { name: 'v' quantity: VELOCITY_Y at { x: 0 y: 0.5 } }");
  for (std::uint64_t n = 0; n <= 200; ++n) run.advance(n, kDt);
  const double t = 200 * kDt;
  EXPECT_NEAR(run.predicted.histories(0), -5 * t * t, 1e-12);
  EXPECT_NEAR(run.predicted.histories(1), -10 * (t - kDt / 2), 1e-12);  // half a step before
  // momentum by the snapshot's velocities (half a step later) and the nodes' masses
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  const auto& piece = snapshot.pieces(0);
  double momentum = 0;
  for (int i = 0; i < piece.points_size() / 2; ++i) {
    const double x = piece.points(2 * i), y = piece.points(2 * i + 1);
    const double share = (x == 0 || x == 6 ? 0.5 : 1.0) * (y == 0 || y == 1 ? 0.5 : 1.0);
    momentum += 2500 * 0.125 * share * piece.point_fields(1).values(3 * i);
  }
  EXPECT_NEAR(momentum, 3e4 * (t + kDt / 2), 1e-10 * 3e4 * t);
}

// Edge loads are shared by length: half as much at the ends of the edge as between; point loads equally.
TEST(Participant, SharesLoadsAsTheirKindSays) {
  const auto first_velocities = [](const std::string& kind) {
    Conversation run(kind + " { where { x_max: 0 } force { y: 1000 } }");
    run.advance(0, kDt);
    wire::Snapshot snapshot;
    run.participant.snapshot({}, snapshot);
    std::vector<double> momenta;
    for (int row = 0; row < 5; ++row)
      momenta.push_back(snapshot.pieces(0).point_fields(1).values(3 * 13 * row + 1) *
                        (row == 0 || row == 4 ? 1 : 2) * 2500 * 0.125 / 4);
    return momenta;
  };
  const double half = kDt / 2;
  const auto near = [](double value) { return testing::DoubleNear(value, 1e-15); };
  EXPECT_THAT(
      first_velocities("edge_loads"),
      ElementsAre(near(125 * half), near(250 * half), near(250 * half), near(250 * half), near(125 * half)));
  EXPECT_THAT(first_velocities("point_loads"), testing::Each(near(200 * half)));
}

// The boundary that appears where zones vanish is not loaded by an edge load that covers everything.
TEST(Participant, EdgeLoadsActOnTheOutlineOfTheBlockOnly) {
  const Conversation whole("");
  Conversation run("edge_loads { where {} force { x: 1000 } }", ramp(whole.model, 2, 4));
  run.advance(0, kDt);
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  const auto& v = snapshot.pieces(0).point_fields(1);
  EXPECT_EQ(v.values(3 * (2 * 9 + 8)), 0);  // middle of the cut at x = 4 m
  EXPECT_GT(v.values(3 * 8), 0);            // lower outline at x = 4 m
}

// The operator interpolates from the grid points that take part, and knows prescribed components.
TEST(Participant, AnswersTheOperator) {
  Conversation run("motions { where { x_max: 0 } velocity { x: 0 } }");
  wire::Couple couple;
  for (const double value : {0.0, 0.25, 0.25, 0.125}) couple.add_points(value);
  wire::Operator op;
  run.participant.couple(couple, op);
  EXPECT_THAT(op.row_starts(), ElementsAre(0, 1, 5));
  EXPECT_THAT(op.columns(), ElementsAre(2, 0, 1, 3, 2));
  EXPECT_THAT(op.values(), ElementsAre(1, 0.25, 0.25, 0.25, 0.25));
  const double mass = 2500 * 0.125;
  ASSERT_EQ(op.inverse_masses_size(), 8);
  EXPECT_EQ(op.inverse_masses(0), 0);
  EXPECT_NEAR(op.inverse_masses(1), 4 / mass, 1e-15);
  EXPECT_NEAR(op.inverse_masses(2), 2 / mass, 1e-15);
}

// Impulses enter as N^T impulse / mass, before the motion of the next step.
TEST(Participant, AppliesImpulsesBeforeItMoves) {
  Conversation run("histories { name: 'u' quantity: DISPLACEMENT_X at { x: 3 y: 0.5 } }");
  wire::Couple couple;
  couple.add_points(3);
  couple.add_points(0.5);
  wire::Operator op;
  run.participant.couple(couple, op);
  EXPECT_THAT(run.advance(0, kDt).velocities(), ElementsAre(0, 0));
  run.advance(1, kDt, {500, 0});
  EXPECT_NEAR(run.predicted.histories(0), kDt * 500 * op.inverse_masses(0), 1e-18);
  EXPECT_LT(run.predicted.velocities(0), 500 * op.inverse_masses(0));  // the zones pull back
  EXPECT_GT(run.predicted.energies().strain(), 0);
}

// A snapshot shows the velocities after the correction by its impulses, which the next step then brings no
// more.
TEST(Participant, SnapshotShowsTheCorrectedVelocities) {
  const auto displacement = [](bool with_snapshot) {
    Conversation run("histories { name: 'u' quantity: DISPLACEMENT_X at { x: 3 y: 0.5 } }");
    wire::Couple couple;
    couple.add_points(3);
    couple.add_points(0.5);
    wire::Operator op;
    run.participant.couple(couple, op);
    run.advance(0, kDt);
    if (!with_snapshot) return run.advance(1, kDt, {500, 0}).histories(0);
    wire::SnapshotRequest request;
    request.add_impulses(500);
    request.add_impulses(0);
    wire::Snapshot snapshot;
    run.participant.snapshot(request, snapshot);
    EXPECT_EQ(snapshot.pieces(0).point_fields(1).values(3 * (2 * 13 + 6)), 500 * op.inverse_masses(0));
    return run.advance(1, kDt).histories(0);
  };
  EXPECT_GT(displacement(true), 0);
  EXPECT_EQ(displacement(true), displacement(false));
}

// Snapshots are one piece of quadrilaterals with vectors of three components; finishing counts the work.
TEST(Participant, FillsSnapshotAndFarewell) {
  Conversation run(
      "motions { where { x_max: 0 } velocity { x: -1 y: 0 } } motions { where { x_min: 6 } velocity { x: 1 } "
      "}");
  for (std::uint64_t n = 0; n <= 50; ++n) run.advance(n, kDt);
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  ASSERT_EQ(snapshot.pieces_size(), 1);
  const auto& piece = snapshot.pieces(0);
  EXPECT_EQ(piece.name(), "grid");
  EXPECT_EQ(piece.shape(), wire::Piece::QUADS);
  EXPECT_EQ(piece.points_size(), 2 * 65);
  EXPECT_EQ(piece.connectivity_size(), 4 * 48);
  EXPECT_EQ(piece.point_fields(0).name(), "displacement_m");
  EXPECT_EQ(piece.point_fields(0).values_size(), 3 * 65);
  EXPECT_EQ(piece.cell_fields(0).name(), "stress_Pa");
  EXPECT_GT(piece.cell_fields(0).values(0), 0);  // pulled apart
  EXPECT_NEAR(piece.point_fields(0).values(0), -50 * kDt, 1e-15);
  EXPECT_EQ(piece.cell_fields(1).values(7), 1);
  wire::Bye bye;
  run.participant.finish(bye);
  EXPECT_EQ(bye.updates(), 48u * 50u);  // step 0 moves nothing
  EXPECT_GE(bye.cpu_seconds(), 0);
}

// Three zones in a row, sheared for 50 steps: the fields of zones by name.
std::map<std::string, std::vector<double>> sheared_row(const std::string& materials, wire::Model& model) {
  FdmParticipant participant;
  const auto setup = setup_of(
      "blocks { name: 'left' rectangle { x_min: 0 x_max: 1 y_min: 0 y_max: 1 } along { zones: 1 } "
      "across { zones: 1 } } "
      "blocks { name: 'right' rectangle { x_min: 1 x_max: 3 y_min: 0 y_max: 1 } along { zones: 2 } "
      "across { zones: 1 } } " +
          materials +
          "motions { where { x_max: 0 } velocity { x: 0 y: 0 } } "
          "motions { where { x_min: 3 } velocity { x: 0 y: 1 } }",
      "", "plane: PLANE_STRAIN material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } ");
  set_up(participant, setup, model);
  wire::Interface interface;
  participant.weigh({}, interface);
  wire::Advance advance;
  wire::Predicted predicted;
  advance.set_dt(kDt);
  for (std::uint64_t n = 0; n <= 50; ++n) {
    advance.set_step(n);
    participant.advance(advance, predicted);
  }
  wire::Snapshot snapshot;
  participant.snapshot({}, snapshot);
  std::map<std::string, std::vector<double>> found;
  for (const auto& field : snapshot.pieces(0).cell_fields())
    found[field.name()] = {field.values().begin(), field.values().end()};
  return found;
}

// Zones show material and group by number, with names from the beginning, and where ground can yield how it
// did.
TEST(Participant, ShowsMaterialGroupAndYield) {
  wire::Model model;
  auto found = sheared_row(
      "materials { where { x_min: 2 } material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 "
      "mohr_coulomb { cohesion: 10 } } } ",
      model);
  EXPECT_THAT(model.groups(), testing::ElementsAre("", "left", "right"));
  EXPECT_THAT(model.materials(), testing::ElementsAre("material", "continuum.materials[0].material"));
  EXPECT_THAT(found["material"], testing::ElementsAre(0, 0, 1));
  EXPECT_THAT(found["group"], testing::ElementsAre(1, 2, 2));
  EXPECT_EQ(found["yield_state"][0], 0);
  EXPECT_EQ(static_cast<unsigned>(found["yield_state"][2]) & kShearNow, kShearNow);
  EXPECT_EQ(found["plastic_shear_strain"][0], 0);
  EXPECT_GT(found["plastic_shear_strain"][2], 0);
}

// Hysteretic zones tell that they are hysteretic and no yield, at rest as beyond the last strain of their
// curve.
TEST(Participant, HystereticZonesDoNotYield) {
  const auto hysteretic = [](const std::string& where, const std::string& memory) {
    return "materials { where { " + where +
           " } material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 hysteretic { "
           "hyperbola { reference_strain: 1e-9 } memory: " +
           memory + " } } } ";
  };
  wire::Model model;
  const auto found =
      sheared_row(hysteretic("x_max: 2", "ELEMENTS") + hysteretic("x_min: 2", "REVERSALS"), model);
  EXPECT_THAT(found.at("yield_state"), testing::Each(kHysteretic));
}

// A velocity that is not finite ends the run with step, place and value.
TEST(Participant, StopsWhereAVelocityIsNotFinite) {
  Conversation run("");
  wire::Couple couple;
  couple.add_points(3);
  couple.add_points(0.5);
  wire::Operator op;
  run.participant.couple(couple, op);
  run.advance(0, kDt);
  try {
    run.advance(1, kDt, {std::numeric_limits<double>::infinity(), 0});
    FAIL() << "no error";
  } catch (const protocol::Unstable& error) {
    EXPECT_THAT(error.what(), HasSubstr("step 1: the velocity of the grid point at ("));
  }
}

// Requests that contradict an earlier one are refused, not computed.
TEST(Participant, RefusesContradictoryRequests) {
  wire::Weights weights;
  weights.add_weights(1);
  EXPECT_THROW(Conversation("", weights), protocol::RequestError);
  const Conversation whole("");
  weights = ramp(whole.model, 2, 4);
  weights.set_weights(3, std::nan(""));
  EXPECT_THROW(Conversation("", weights), protocol::RequestError);
  Conversation run("");
  EXPECT_THROW(run.advance(0, -kDt), protocol::RequestError);
  run.advance(0, kDt);
  EXPECT_THROW(run.advance(1, 2 * kDt), protocol::RequestError);
  EXPECT_THROW(run.advance(1, kDt, {1, 2}), protocol::RequestError);
  wire::Couple couple;
  couple.add_points(1);
  wire::Operator op;
  EXPECT_THROW(run.participant.couple(couple, op), protocol::RequestError);
}

}  // namespace
}  // namespace adit::fdm::test::participant_test
