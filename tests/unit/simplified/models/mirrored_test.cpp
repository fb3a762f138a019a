// Requirement: a tunnel has no first end. Counted from its other end, with all that is given mirrored, it
// answers mirrored, to rounding, in beam and chain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/simplified/scenes.hpp"

namespace adit::simplified::mirrored_test {
namespace {

// Shear forces are those of pieces of the stiffness 12 EI/l^3 = 1.6e11 N/m: rounding of displacements of 0.1
// m by 1e-16 of them, a few times over, makes 1e-2 N of 1e6 N.
constexpr double kLength = 200, kRounding = 1e-8;  // of the largest value

// Sections that differ in all, with joints within them and between them, in ground whose profiles differ.
scene::Scene unlike() {
  scene::Scene scene = testing::tunnel();
  scene::Simplified& simplified = *scene.mutable_simplified();
  scene::Section& second = *simplified.mutable_tunnel()->mutable_sections(1);
  second.set_width(12);
  second.set_height(5);
  second.set_area(15);
  second.set_lateral_inertia(200);
  second.set_vertical_inertia(40);
  second.set_young_modulus(30e9);
  second.set_mass(9e4);
  for (scene::Section& section : *simplified.mutable_tunnel()->mutable_sections())
    section.set_element_length(5);
  simplified.mutable_tunnel()->mutable_joints(0)->clear_rotation_stiffness();
  simplified.mutable_excitation()->clear_incidence();
  simplified.mutable_excitation()->set_through_ground(true);
  simplified.mutable_stations(0)->set_chainage(90.5);
  *simplified.mutable_ground() = testing::scene_of(R"(
    simplified { ground { modes: 4 column_spacing: 20 joined: true
      profiles { chainage: 0
        layers { thickness: 12 shear_velocity: 180 density: 1800 poisson_ratio: 0.48 damping_ratio: 0.05 }
        layers { thickness: 20 shear_velocity: 350 density: 2000 poisson_ratio: 0.4 damping_ratio: 0.03 } }
      profiles { chainage: 200
        layers { thickness: 25 shear_velocity: 300 density: 1900 poisson_ratio: 0.3 damping_ratio: 0.04 }
        layers { thickness: 8 shear_velocity: 420 density: 2000 poisson_ratio: 0.2 damping_ratio: 0.02 } }
    } })")
                                     .simplified()
                                     .ground();
  return scene;
}

scene::Scene mirrored(scene::Scene scene) {
  scene::Simplified& simplified = *scene.mutable_simplified();
  auto& sections = *simplified.mutable_tunnel()->mutable_sections();
  sections.SwapElements(0, 1);
  for (scene::Section& section : sections) {
    const double from = section.from();
    section.set_from(kLength - section.to());
    section.set_to(kLength - from);
  }
  auto& profiles = *simplified.mutable_ground()->mutable_profiles();
  profiles.SwapElements(0, 1);
  for (scene::SoilProfile& profile : profiles) profile.set_chainage(kLength - profile.chainage());
  for (scene::Station& station : *simplified.mutable_stations())
    station.set_chainage(kLength - station.chainage());
  scene::Excitation& excitation = *simplified.mutable_excitation();
  excitation.set_axial(-excitation.axial());
  return scene;
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

void expect_reversed(const std::vector<double>& found, const std::vector<double>& expected, double sign,
                     const std::string& name) {
  ASSERT_EQ(found.size(), expected.size());
  const double largest = largest_of(expected);
  EXPECT_GT(largest, 0) << name;
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_NEAR(found[i], sign * expected[expected.size() - 1 - i], kRounding * largest) << name << " " << i;
}

// Motion across the tunnel and its moments keep their sign in the mirror, axial forces too; shear changes it.
void expect_mirrored(const Response& found, const Response& expected) {
  ASSERT_EQ(found.envelopes.size(), expected.envelopes.size());
  for (std::size_t e = 0; e < found.envelopes.size(); ++e) {
    const Envelope &mirror = found.envelopes[e], &envelope = expected.envelopes[e];
    if (largest_of(envelope.greatest) == 0) continue;  // of vertical motion, which is not given
    const bool turned = envelope.name.starts_with("shear");
    const double sign = turned ? -1 : 1;
    expect_reversed(mirror.greatest, turned ? envelope.least : envelope.greatest, sign, envelope.name);
    expect_reversed(mirror.least, turned ? envelope.greatest : envelope.least, sign, envelope.name);
  }
  const auto of_joints = [](const Response& response, double JointResponse::*quantity) {
    std::vector<double> values;
    for (const JointResponse& joint : response.joints) values.push_back(joint.*quantity);
    return values;
  };
  for (const auto quantity : {&JointResponse::opening, &JointResponse::compression})
    expect_reversed(of_joints(found, quantity), of_joints(expected, quantity), 1, "joints");
  ASSERT_EQ(found.histories.rows.size(), expected.histories.rows.size());
  double largest = 0, difference = 0;  // of the lateral displacement at the station
  for (std::size_t n = 0; n < found.histories.rows.size(); ++n) {
    largest = std::max(largest, std::abs(expected.histories.rows[n][2]));
    difference = std::max(difference, std::abs(found.histories.rows[n][2] - expected.histories.rows[n][2]));
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(difference, kRounding * largest);
}

class Mirrored : public ::testing::TestWithParam<scene::Simplified::Model> {};

TEST_P(Mirrored, TunnelAnswersMirroredToLateralMotion) {
  const scene::Scene scene = testing::with_model(unlike(), GetParam());
  expect_mirrored(testing::response_of(mirrored(scene)), testing::response_of(scene));
}

TEST_P(Mirrored, TunnelAnswersMirroredToBothMotions) {
  scene::Scene scene = testing::with_model(unlike(), GetParam());
  scene.mutable_simplified()->mutable_excitation()->set_axial(0.5);
  expect_mirrored(testing::response_of(mirrored(scene)), testing::response_of(scene));
}

INSTANTIATE_TEST_SUITE_P(Models, Mirrored,
                         ::testing::Values(scene::Simplified::BEAM, scene::Simplified::CHAIN),
                         [](const auto& info) { return info.index == 0 ? "Beam" : "Chain"; });

}  // namespace
}  // namespace adit::simplified::mirrored_test
