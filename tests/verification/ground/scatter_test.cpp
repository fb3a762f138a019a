// Requirement: ground whose stiffness and strength differ from place to place settles, yields and carries
// waves as its factors say.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "coupler/stepping/statics.hpp"
#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::scatter_test {
namespace {

std::string field(const std::string& of, const std::string& rows) {
  return "scatter { of: " + of + " path: 'field.csv' content: 'x_m,y_m,factor\\n" + rows + "' } ";
}

std::string block(double width, double height, int across, int up) {
  return "block { x_min: 0 x_max: " + std::to_string(width) + " y_min: 0 y_max: " + std::to_string(height) +
         " zones_x: " + std::to_string(across) + " zones_y: " + std::to_string(up) + " } ";
}

scene::Scene scene_of(const std::string& text) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene)) << text;
  return scene;
}

// The zones at rest, or after some steps of time.
wire::Piece settled(const std::string& text) {
  coupler::Model model = test::local_model(scene_of(text));
  coupler::Stepper stepper(model);
  relax(model, stepper);
  stepper.step(0, {.energies = true, .histories = true});
  return stepper.snapshots().front().pieces(0);
}

wire::Piece after(std::uint64_t steps, const std::string& text) {
  coupler::Model model = test::local_model(scene_of(text));
  coupler::Stepper stepper(model);
  for (std::uint64_t n = 0; n <= steps; ++n) stepper.step(n, {});
  return stepper.snapshots().front().pieces(0);
}

std::vector<double> values(const google::protobuf::RepeatedPtrField<wire::Field>& fields,
                           const std::string& name) {
  const auto found = std::ranges::find(fields, name, &wire::Field::name);
  return {found->values().begin(), found->values().end()};
}

double largest(const std::vector<double>& values) {
  double found = 0;
  for (const double value : values) found = std::max(found, std::abs(value));
  return found;
}

constexpr double kHeight = 10, kYoung = 50e6, kPoisson = 0.3, kDensity = 2000, kGravity = 10;

double settlement_with(int zones) {
  const wire::Piece piece = settled(
      "material { young_modulus: 50e6 poisson_ratio: 0.3 density: 2000 } time { duration: 1e-3 } "
      "statics { unbalanced_ratio: 1e-9 count_from_stage: 0 } continuum { " +
      block(1, kHeight, 1, zones) + field("STIFFNESS", "0,0,4\\n0,10,1\\n") +
      "body_loads { acceleration { y: -10 } } motions { where { x_max: 0 } velocity { x: 0 } } "
      "motions { where { x_min: 1 } velocity { x: 0 } } motions { where { y_max: 0 } velocity { y: 0 } } }");
  return largest(values(piece.point_fields(), "displacement_m"));
}

// Of a column whose modulus is M (1 + a (H - y)) under its weight: the integral of the weight above over the
// modulus,
//   rho g / M  (H - ln(1 + a H) / a) / a.
TEST(ScatteredGround, SettlesByTheIntegralOverItsModulus) {
  const double modulus = kYoung * (1 - kPoisson) / ((1 + kPoisson) * (1 - 2 * kPoisson)), a = 3 / kHeight;
  const double expected = kDensity * kGravity / modulus * (kHeight - std::log(1 + a * kHeight) / a) / a;
  const double coarse = settlement_with(5) / expected - 1, fine = settlement_with(20) / expected - 1;
  EXPECT_LT(std::abs(fine), 2e-3);
  EXPECT_NEAR(std::log(coarse / fine) / std::log(4), 2, 0.1);  // second order
}

// Clay between smooth plates that close slowly bears 2 c of each place.
constexpr double kCohesion = 1e5;
TEST(ScatteredGround, YieldsUnderItsOwnStrength) {
  const wire::Piece piece = after(
      12'000,
      "material { young_modulus: 50e6 poisson_ratio: 0.3 density: 2000 mohr_coulomb { cohesion: 1e5 } } "
      "time { duration: 100 } continuum { damping { local { alpha: 0.5 } } " +
          block(4, 2, 8, 4) + field("STRENGTH", "0,0,0.5\\n4,0,1.5\\n") + field("STIFFNESS", "0,0,2\\n") +
          "motions { where { y_max: 0 } velocity { y: 0 } } motions { where { x_max: 0 y_max: 0 } velocity { "
          "x: "
          "0 } } motions { where { y_min: 2 } velocity { y: -1e-3 } } }");
  const auto stress = values(piece.cell_fields(), "stress_Pa"),
             strength = values(piece.cell_fields(), "strength_factor"),
             stiffness = values(piece.cell_fields(), "stiffness_factor");
  ASSERT_EQ(strength.size(), 32u);
  for (std::size_t z = 0; z < strength.size(); ++z) {
    EXPECT_NEAR(strength[z], 0.5 + (0.25 + 0.5 * static_cast<double>(z % 8)) / 4, 1e-12);
    EXPECT_EQ(stiffness[z], 2);
    EXPECT_NEAR(stress[3 * z + 1] / (-2 * kCohesion * strength[z]), 1, 1e-3);
  }
}

// A vertical wave in layers of a field stays plane: the free field beside the grid has the field, too.
TEST(ScatteredGround, IsTheSameInTheFreeField) {
  const wire::Piece piece = after(
      400,
      "material { young_modulus: 50e6 poisson_ratio: 0.3 density: 2000 } time { duration: 1 } continuum { " +
          block(3, 10, 6, 20) + field("STIFFNESS", "0,0,4\\n0,6,0.5\\n0,10,1\\n") +
          "base { acceleration { ricker { frequency: 5 time: 0.3 } peak: 1 } } free_field { left: true "
          "right: true } }");
  const auto motion = values(piece.point_fields(), "displacement_m");
  std::vector<double> across, up;
  for (std::size_t i = 0; 3 * i < motion.size(); ++i) {
    across.push_back(motion[3 * i]);
    up.push_back(motion[3 * i + 1]);
  }
  EXPECT_GT(largest(across), 1e-6);
  EXPECT_LT(largest(up), 1e-10 * largest(across));
  for (std::size_t i = 0; i < across.size(); ++i)
    EXPECT_NEAR(across[i], across[i / 7 * 7], 1e-10 * largest(across));
}

// The mirrored field under the mirrored load moves as the mirror image.
TEST(ScatteredGround, IsMirroredWithItsField) {
  const auto run = [](const std::string& rows, const std::string& push) {
    return values(
        after(300,
              "material { young_modulus: 50e6 poisson_ratio: 0.3 density: 2000 mohr_coulomb { cohesion: 2e4 "
              "friction_angle: 0.4 } } time { duration: 1 } continuum { " +
                  block(4, 2, 8, 4) + field("STIFFNESS", rows) + field("STRENGTH", rows) +
                  "motions { where { y_max: 0 } velocity { x: 0 y: 0 } } edge_loads { where { y_min: 2 } "
                  "force { x: " +
                  push + " y: -1e5 } } }")
            .point_fields(),
        "displacement_m");
  };
  const auto one = run("0,0,0.5\\n1,0,2\\n4,0,1\\n", "1e5"),
             other = run("0,0,1\\n3,0,2\\n4,0,0.5\\n", "-1e5");
  ASSERT_EQ(one.size(), 3 * 9 * 5u);
  EXPECT_GT(largest(one), 1e-3);
  for (std::size_t row = 0; row < 5; ++row)
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t here = 3 * (9 * row + k), there = 3 * (9 * row + 8 - k);
      EXPECT_NEAR(one[here], -other[there], 1e-9 * largest(one));
      EXPECT_NEAR(one[here + 1], other[there + 1], 1e-9 * largest(one));
    }
}

}  // namespace
}  // namespace adit::scatter_test
