// Requirement: a lining carries what the ground sheds after it was installed, not before.
#include <fmt/format.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "coupler/stepping/statics.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::staged_test {
namespace {

constexpr double kPressure = 1e6, kRadius = 2, kShear = 1e8, kPoisson = 0.25;
constexpr double kThickness = 0.2, kYoung = 30e9, kLiningPoisson = 0.2;

// A tunnel of stage 1 in ground under the same pressure all around, whose outline 30 radii away is held.
// `materials`: others of the same stiffness, as text.
double mean_thrust(std::uint32_t lining_stage, double released = 1, const std::string& materials = "") {
  const std::string text = fmt::format(
      "material {{ young_modulus: {} poisson_ratio: {} density: 2000 }} time {{ duration: 1e-3 dt_factor: "
      "0.9 }} "
      "initial_stress {{ xx: {} yy: {} }} statics {{ unbalanced_ratio: 1e-6 keep_displacements: true }} "
      "continuum {{ "
      "blocks {{ name: 'core' rectangle {{ x_min: -1 x_max: 1 y_min: -1 y_max: 1 }} along {{ zones: 12 }} "
      "across {{ zones: 12 }} }} "
      "blocks {{ name: 'core' ring {{ centre {{ x: 0 y: 0 }} inner_side: 2 outer_radius: {} }} "
      "along {{ zones: 48 }} across {{ zones: 3 }} }} "
      "blocks {{ ring {{ centre {{ x: 0 y: 0 }} inner_radius: {} outer_side: 120 }} along {{ zones: 48 }} "
      "across {{ zones: 28 ratio: 1.12 }} }} "
      "{} excavations {{ where {{ group: 'core' }} stage: 1 released: {} }} "
      "linings {{ name: 'l' along {{ circle {{ centre {{ x: 0 y: 0 }} radius: {} }} }} thickness: {} "
      "young_modulus: {} poisson_ratio: {} stage: {} }} "
      "motions {{ where {{ x_min: 60 }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ x_max: -60 }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ y_min: 60 }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ y_max: -60 }} velocity {{ x: 0 y: 0 }} }} }}",
      2 * kShear * (1 + kPoisson), kPoisson, -kPressure, -kPressure, kRadius, kRadius, materials, released,
      kRadius, kThickness, kYoung, kLiningPoisson, lining_stage);
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene)) << text;
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  relax(model, stepper);
  const auto snapshot = stepper.snapshots().front();
  const auto& fields = snapshot.pieces(1).point_fields();
  const auto thrust = std::ranges::find(fields, "thrust_N", &wire::Field::name);
  double sum = 0;
  for (const double value : thrust->values()) sum += value / thrust->values_size();
  return sum;
}

// Installed as the tunnel is excavated, it shares the pressure with the ground: both move inwards by
//   u = (p_0 - p) R/2G = p R^2/E'A,   N = -p R.
TEST(StagedLining, SharesThePressureOfTheExcavation) {
  const double axial = kYoung / (1 - kLiningPoisson * kLiningPoisson) * kThickness;
  const double pressure = kPressure / (1 + 2 * kShear * kRadius / axial);
  EXPECT_NEAR(mean_thrust(1) / (-pressure * kRadius), 1, 0.01);
}

// Installed once the ground has come to rest, it carries nothing: no more than the unrest that was left.
TEST(StagedLining, CarriesNothingOfWhatWasBefore) {
  EXPECT_LE(std::abs(mean_thrust(2)), 1e-3 * kPressure * kRadius);
}

// Installed when a share of the pressure is released, it shares the rest only.
TEST(StagedLining, SharesWhatIsReleasedLater) {
  EXPECT_NEAR(mean_thrust(2, 0.6) / mean_thrust(1), 0.4, 2e-3);
}

// Requirement: the forces held are those of the zones that go, however many materials the ground has and
// wherever these stand among them.
TEST(StagedLining, SharesWhatIsReleasedLaterInGroundOfSeveralMaterials) {
  const auto material = [](const char* where) {
    return fmt::format(
        "materials {{ where {{ {} }} material {{ young_modulus: {} poisson_ratio: {} density: 2000 }} }} ",
        where, 2 * kShear * (1 + kPoisson), kPoisson);
  };
  const double of_one = mean_thrust(2, 0.6);
  for (const std::string& materials : {material("group: 'core'"), material("y_min: 0"),
                                       material("y_max: 0") + material("x_min: 0 y_min: 0")})
    EXPECT_NEAR(mean_thrust(2, 0.6, materials) / of_one, 1, 1e-4) << materials;
}

}  // namespace
}  // namespace adit::staged_test
