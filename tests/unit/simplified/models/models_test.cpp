// Beam and chain of one scene describe the same tunnel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simplified/models/differences.hpp"
#include "simplified/models/solve.hpp"
#include "tests/unit/simplified/scenes.hpp"

namespace adit::simplified::models_test {
namespace {

using testing::response_of;
using testing::tunnel;
using testing::with_model;

void expect_equal_peaks(const Response& beam, const Response& chain, const std::string& name,
                        double tolerance) {
  const Peak of_beam = peak(beam.chainage, *find(beam, name)),
             of_chain = peak(chain.chainage, *find(chain, name));
  EXPECT_GT(of_beam.value, 0);
  EXPECT_NEAR(of_chain.value, of_beam.value, tolerance * of_beam.value) << name;
}

double widest(const Response& response) {
  return std::ranges::max(response.joints, {}, &JointResponse::opening).opening;
}

void expect_equal_joints(const Response& beam, const Response& chain, double tolerance) {
  ASSERT_EQ(chain.joints.size(), beam.joints.size());
  const double largest = tolerance * widest(beam);
  EXPECT_GT(largest, 0);
  for (std::size_t j = 0; j < beam.joints.size(); ++j) {
    EXPECT_NEAR(chain.joints[j].opening, beam.joints[j].opening, largest) << j;
    EXPECT_NEAR(chain.joints[j].compression, beam.joints[j].compression, largest) << j;
  }
}

// Requirement: on a tunnel that both can represent, beam and chain agree to 1 %: forces, strains, histories;
// what the joints do agrees to 3 %, because the beam reads it at its springs and the chain at the outer edge.
class BeamAndChain : public ::testing::TestWithParam<scene::Scene (*)()> {};

TEST_P(BeamAndChain, AgreeOnAxialMotion) {
  scene::Scene scene = GetParam()();
  scene.mutable_simplified()->mutable_excitation()->clear_lateral();
  scene.mutable_simplified()->mutable_excitation()->set_axial(1);
  const Response beam = response_of(with_model(scene, scene::Simplified::BEAM));
  const Response chain = response_of(with_model(scene, scene::Simplified::CHAIN));
  expect_equal_peaks(beam, chain, "axial_force", 0.01);
  expect_equal_peaks(beam, chain, "strain", 0.01);
  EXPECT_NEAR(widest(chain), widest(beam), 0.01 * widest(beam));
  expect_equal_joints(beam, chain, 0.03);
}

TEST_P(BeamAndChain, AgreeOnLateralMotion) {
  const Response beam = response_of(with_model(GetParam()(), scene::Simplified::BEAM));
  const Response chain = response_of(with_model(GetParam()(), scene::Simplified::CHAIN));
  for (const char* name : {"moment_lateral", "shear_lateral", "strain"})
    expect_equal_peaks(beam, chain, name, 0.01);
  expect_equal_joints(beam, chain, 0.03);
  ASSERT_EQ(beam.histories.rows.size(), chain.histories.rows.size());
  double largest = 0, difference = 0;  // of the lateral displacement at the station
  for (std::size_t n = 0; n < beam.histories.rows.size(); ++n) {
    largest = std::max(largest, std::abs(beam.histories.rows[n][2]));
    difference = std::max(difference, std::abs(beam.histories.rows[n][2] - chain.histories.rows[n][2]));
  }
  EXPECT_LT(difference, 0.01 * largest);
}

INSTANTIATE_TEST_SUITE_P(Tunnels, BeamAndChain,
                         ::testing::Values(&testing::tunnel, &testing::immersed_tunnel),
                         [](const auto& info) { return info.index == 0 ? "Tube" : "Immersed"; });

// Requirement: a joint has the outline that the sections before and after it have in common.
TEST(BeamModel, JointsHaveTheOutlineThatBothSectionsHave) {
  scene::Scene scene = tunnel();
  auto& line = *scene.mutable_simplified()->mutable_tunnel();
  for (auto& section : *line.mutable_sections()) section.set_element_length(25);
  line.mutable_sections(1)->set_width(14);
  line.mutable_sections(1)->set_height(14);
  line.mutable_joints(0)->clear_rotation_stiffness();
  const beam::Tunnel model = beam_model(scene.simplified(), divide(line));
  ASSERT_EQ(model.joints.size(), 7u);
  const auto half_width = [](const beam::Joint& joint) {
    return std::ranges::max(joint.springs, {}, &beam::Joint::Spring::y).y;
  };
  const double narrow = half_width(model.joints[0]);
  EXPECT_GT(narrow, 0);
  for (const beam::Joint& joint : model.joints)
    EXPECT_DOUBLE_EQ(half_width(joint), joint.chainage > 100 ? 2 * narrow : narrow) << joint.chainage;
}

// Requirement: a wave that passes opens the joints more than the same motion everywhere at once.
TEST(Excitation, PassageOpensJointsThatUniformMotionLeavesClosed) {
  scene::Scene scene = tunnel();
  scene.mutable_simplified()->mutable_excitation()->clear_lateral();
  scene.mutable_simplified()->mutable_excitation()->set_axial(1);
  const double passing = widest(response_of(scene));
  scene.mutable_simplified()->mutable_excitation()->clear_incidence();
  EXPECT_LT(widest(response_of(scene)), 0.01 * passing);
}

// Requirement: the last row of the histories is the end of the run, also where the rows' interval does not
// divide it.
TEST(Histories, EndWithTheRun) {
  scene::Scene scene = tunnel();
  scene.mutable_output()->set_history_interval(0.03);
  scene::SoilProfile& profile = *scene.mutable_simplified()->mutable_ground()->add_profiles();
  profile.set_chainage(0);
  profile.add_layers()->set_thickness(20);
  profile.mutable_layers(0)->set_shear_velocity(200);
  profile.mutable_layers(0)->set_density(1900);
  *scene.mutable_simplified()->mutable_ground()->add_profiles() = profile;
  scene.mutable_simplified()->mutable_ground()->mutable_profiles(1)->set_chainage(200);
  scene.mutable_simplified()->mutable_excitation()->set_through_ground(true);
  for (const auto model : {scene::Simplified::BEAM, scene::Simplified::CHAIN, scene::Simplified::COLUMN}) {
    const Response response = response_of(with_model(scene, model));
    ASSERT_EQ(response.histories.rows.size(), 68U) << model;
    EXPECT_DOUBLE_EQ(response.histories.rows.back()[0], 2) << model;
    EXPECT_NEAR(response.histories.rows[66][0], 1.98, 1e-12) << model;
  }
}

// Requirement: an interval of less than half a step gives a row at every step.
TEST(Histories, HaveNoMoreRowsThanSteps) {
  scene::Scene scene = tunnel();
  scene.mutable_output()->set_history_interval(scene.time().dt() / 5);
  const Response response = response_of(scene);
  EXPECT_NEAR(response.histories.rows[1][0], scene.time().dt(), 1e-12);
  EXPECT_DOUBLE_EQ(response.histories.rows.back()[0], scene.time().duration());
}

// Requirement: the fourth-order differences err by (w dt)^4/30 of a sine's rate.
TEST(Rates, AreOfFourthOrder) {
  const double omega = 2 * std::numbers::pi;
  double error[2] = {};
  for (int k = 0; k < 2; ++k) {
    const double dt = 0.05 / (1 + k);
    std::vector<double> time, values;
    for (int n = 0; n <= 40 * (1 + k); ++n) {
      time.push_back(n * dt);
      values.push_back(std::sin(omega * n * dt));
    }
    const std::vector<double> rate = rates(values, time, 1);
    for (std::size_t n = 4; n + 4 < time.size(); ++n)
      error[k] = std::max(error[k], std::abs(rate[n] - omega * std::cos(omega * time[n])));
    EXPECT_NEAR(error[k], omega * std::pow(omega * dt, 4) / 30, 0.1 * error[k]);
  }
}

// Requirement: rates of t^3 of two places: exact by the fourth order, dt^2 more beside the ends, and
// one-sided in the first and the last row.
TEST(Rates, TakeLessOrderTowardsTheEnds) {
  const double dt = 0.5;
  std::vector<double> time, values;
  for (int n = 0; n < 7; ++n) {
    time.push_back(n * dt);
    for (const double factor : {1.0, -2.0}) values.push_back(factor * std::pow(n * dt, 3));
  }
  const std::vector<double> rate = rates(values, time, 2);
  for (std::size_t n = 0; n < 7; ++n) {
    const double t = time[n];
    const double expected = n == 0             ? dt * dt
                            : n == 6           ? 3 * t * t - 3 * t * dt + dt * dt
                            : n == 1 || n == 5 ? 3 * t * t + dt * dt
                                               : 3 * t * t;
    EXPECT_NEAR(rate[2 * n], expected, 1e-12) << n;
    EXPECT_NEAR(rate[2 * n + 1], -2 * expected, 1e-12) << n;
  }
}

}  // namespace
}  // namespace adit::simplified::models_test
