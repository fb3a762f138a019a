// Requirements on sections of zones: Newton's second law for what lies beyond.
#include "fdm_server/output/grid_sections.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "protocol/errors.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::grid_sections_test {
namespace {

constexpr double kDensity = 2500, kMiddle = 0.5, kCut = 3, kGravity = -4;

// A beam of 6 by 1 m that is held at x = 0, under its weight and a push at its end.
std::string conditions(const std::string& zone, const std::string& damping, const Grid& grid) {
  std::string text =
      "zone: " + zone + " " + damping +
      "motions { where { x_max: 0 } velocity { x: 0 y: 0 } } body_loads { acceleration { y: -4 } } "
      "edge_loads { where { x_min: 6 } force { x: 3e5 y: -1e5 } } "
      "sections { name: 'cut' from { x: 3 y: 0 } to { x: 3 y: 1 } } "
      "sections { name: 'back' from { x: 3 y: 1 } to { x: 3 y: 0 } } ";
  for (const char* cut : {"cut", "back"})
    for (const char* quantity : {"THRUST", "MOMENT", "SHEAR_FORCE"})
      text += fmt::format("histories {{ name: 'h' quantity: {} section: '{}' }} ", quantity, cut);
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    for (const char* quantity : {"ACCELERATION_X", "ACCELERATION_Y"})
      text += fmt::format("histories {{ name: 'p{}' quantity: {} at {{ x: {} y: {} }} }} ", i, quantity,
                          grid.x[i], grid.y[i]);
  return text;
}

struct Case {
  std::string name, zone, law, damping;
};

class GridSectionsOf : public testing::TestWithParam<Case> {};

// Thrust, shear force and moment of the cut are what the beam beyond it needs to move as it does, at every
// step and in any ground; read from its other end the cut has the same thrust and shear force, and a moment
// of the other sign.
TEST_P(GridSectionsOf, MoveWhatLiesBeyond) {
  const auto& [name, zone, law, damping] = GetParam();
  const Grid grid = make_grid({0, 6, 0, 1, 12, 4});
  std::vector<double> beyond;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) beyond.push_back(centroid(corners(grid, z))[0] > kCut);
  const auto masses = lumped_masses(grid, beyond, kDensity);

  const std::string material =
      "plane: PLANE_STRAIN material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2500 " + law + " } ";
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  set_up(participant, setup_of(conditions(zone, damping, grid), kBlock, material), model);
  participant.weigh({}, interface);
  const double dt = model.critical_dt() / 2;
  for (std::uint64_t step = 0; step <= 300; ++step) {
    wire::Advance advance;
    advance.set_step(step);
    advance.set_dt(dt);
    advance.set_want_histories(true);
    wire::Predicted predicted;
    participant.advance(advance, predicted);
    if (step % 50 != 0) continue;
    SCOPED_TRACE(step);
    const auto& values = predicted.histories();
    double x = -3e5, y = 1e5, turn = -1e5 * -3;  // inertia less the loads
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
      const int at = static_cast<int>(6 + 2 * i);
      const double fx = masses[i] * values[at], fy = masses[i] * (values[at + 1] - kGravity);
      x += fx;
      y += fy;
      turn += (grid.x[i] - kCut) * fy - (grid.y[i] - kMiddle) * fx;
    }
    const double scale = 3e5;
    EXPECT_NEAR(values[0], -x, 1e-9 * scale);
    EXPECT_NEAR(values[1], turn, 1e-9 * scale);
    EXPECT_NEAR(values[2], -y, 1e-9 * scale);
    EXPECT_NEAR(values[3], values[0], 1e-9 * scale);
    EXPECT_NEAR(values[4], -values[1], 1e-9 * scale);
    EXPECT_NEAR(values[5], values[2], 1e-9 * scale);
    if (step > 100) {
      EXPECT_GT(std::abs(values[1]), 1e3);
    }
  }
}

const std::string kAssumed = "ASSUMED_STRAIN", kMixed = "MIXED_DISCRETIZATION";
const std::string kMaxwell = "damping { maxwell { ratio: 0.05 low_frequency: 10 high_frequency: 200 } } ";
const std::string kSoil = "mohr_coulomb { cohesion: 2e5 friction_angle: 0.4 }";
INSTANTIATE_TEST_SUITE_P(Ground, GridSectionsOf,
                         testing::Values(Case{"elastic", kAssumed, "", ""}, Case{"mixed", kMixed, "", ""},
                                         Case{"damped", kAssumed, "", kMaxwell},
                                         Case{"yielding", kAssumed, kSoil, ""},
                                         Case{"hysteretic", kMixed,
                                              "hysteretic { hyperbola { reference_strain: 1e-3 } }",
                                              kMaxwell}),
                         [](const auto& info) { return info.param.name; });

std::string refusal(const std::string& conditions) {
  try {
    wire::Setup setup = setup_of(conditions);
    setup.mutable_scene()->mutable_statics();
    FdmParticipant participant;
    wire::Model model;
    wire::Interface interface;
    set_up(participant, setup, model);
    participant.weigh({}, interface);
  } catch (const protocol::UserError& error) {
    return error.what();
  }
  return "";
}

// What cannot be a section is refused by name.
TEST(GridSections, ThatCannotBeAreRefused) {
  using testing::HasSubstr;
  const std::string cut = "sections { name: 'cut' from { x: 3 y: 0 } to { x: 3 y: 1 } } ";
  EXPECT_THAT(refusal(cut + cut), HasSubstr("is `cut`, as that of continuum.sections[0]"));
  EXPECT_THAT(refusal("sections { name: 'a' from { x: 3 y: 0 } to { x: 3 y: 0 } }"),
              HasSubstr("the same place"));
  EXPECT_THAT(refusal("sections { name: 'a' from { x: 3.2 y: 0 } to { x: 3.2 y: 1 } }"),
              HasSubstr("no sides of zones"));
  EXPECT_THAT(refusal("sections { name: 'a' from { x: 0 y: 0 } to { x: 0 y: 1 } }"),
              HasSubstr("on one side only"));
  EXPECT_THAT(refusal(cut + "excavations { where { x_min: 2.4 x_max: 3 } stage: 1 }"),
              HasSubstr("is excavated"));
  EXPECT_THAT(refusal(cut + "histories { name: 'h' quantity: THRUST section: 'cat' }"),
              HasSubstr("did you mean `cut`"));
}

// A motion against another place is the difference of both.
TEST(Histories, CountAgainstAnotherPlace) {
  std::string conditions =
      "motions { where { x_max: 0 } velocity { x: 0 y: 0 } } edge_loads { where { x_min: 6 } force { x: 1e6 "
      "y: 3e5 } } ";
  const std::string here = "at { x: 5.3 y: 0.4 } ", there = "at { x: 1.2 y: 0.9 } ";
  for (const char* quantity :
       {"DISPLACEMENT_X", "DISPLACEMENT_Y", "VELOCITY_X", "VELOCITY_Y", "ACCELERATION_X", "ACCELERATION_Y"})
    for (const auto& place : {here, there, here + "relative_to { x: 1.2 y: 0.9 } "})
      conditions += fmt::format("histories {{ name: 'h' quantity: {} {} }} ", quantity, place);
  Conversation run(conditions);
  for (std::uint64_t step = 0; step <= 60; ++step) run.advance(step, 2e-5);
  const auto& values = run.predicted.histories();
  for (int q = 0; q < 18; q += 3) {
    EXPECT_NEAR(values[q + 2], values[q] - values[q + 1], 1e-12 * std::abs(values[q]));
    EXPECT_NE(values[q + 1], 0);
  }
  EXPECT_THAT(
      refusal("histories { name: 'h' quantity: STRESS_XX at { x: 1 y: 0.5 } relative_to { x: 2 y: 0.5 } }"),
      testing::HasSubstr("stands beside stress_xx"));
}

}  // namespace
}  // namespace adit::fdm::test::grid_sections_test
