// Requirement: an answer that no correct participant gives is refused when it arrives, with the name of the
// participant and what is wrong; what correct ones give passes. tests/integration/faults/test_peers.py shows
// the same with programs.
#include "coupler/answers/answers.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include <string>

#include "protocol/errors.hpp"

namespace adit::coupler::answers_test {
namespace {

constexpr const char* kSoundModel = "critical_dt: 1 x_min: 0 x_max: 1 y_min: 0 y_max: 1 ";
constexpr const char* kAtRest = "points: 4 elements: 1 ";

wire::Frame frame_of(const std::string& kind, const std::string& content) {
  wire::Frame frame;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(kind + " { " + content + " }", &frame))
      << content;
  return frame;
}

void expect_sound(const std::string& kind, const std::string& content) {
  EXPECT_NO_THROW(require_sound(frame_of(kind, content), "dem_server")) << content;
}

void expect_refused(const std::string& kind, const std::string& content, const std::string& what) {
  try {
    require_sound(frame_of(kind, content), "dem_server");
    ADD_FAILURE() << "accepted " << content;
  } catch (const protocol::PeerLost& error) {
    EXPECT_EQ(error.peer(), "dem_server");
    EXPECT_THAT(error.what(), testing::HasSubstr(what));
  }
}

TEST(Answers, Model) {
  const std::string model = kSoundModel;
  expect_sound("model", model + "sample_points: [0.5, 0.5]");
  expect_refused("model", "critical_dt: -1", "critical_dt is -1, which must be positive");
  expect_refused("model", model + "critical_static_dt: -1", "critical_static_dt is -1");
  expect_refused("model", model + "s_wave_speed: -1", "s_wave_speed is -1");
  expect_refused("model", model + "highest_frequency: inf", "model.highest_frequency is inf");
  expect_refused("model", "critical_dt: 1 y_min: 2 y_max: 1", "turned inside out");
  expect_refused("model", model + "sample_points: 0.5", "not pairs");
}

TEST(Answers, Interface) {
  expect_sound("interface", "points: [0, 0, 0, 1, 1, 0] mass: 2");
  expect_refused("interface", "points: [0, 0, 1]", "not pairs");
  expect_refused("interface", "points: [3, 4, 0, 1, 3, 4]", "offers (3, 4) m twice");
  expect_refused("interface", "mass: -1", "mass is -1");
}

TEST(Answers, Predicted) {
  expect_sound("predicted",
               "velocities: [1, -1] energies { strain: -1 shares { name: 'friction' value: -1 } }");
  expect_refused("predicted", "velocities: [1, -inf]", "predicted.velocities[1] is -inf");
  expect_refused("predicted", "hidden_seconds: -1", "hidden_seconds is -1");
  expect_refused("predicted", "strongest { force: -1 }", "strongest.force is -1");
  expect_refused("predicted", "cracks { length: -1 }", "cracks.length is -1");
  expect_refused("predicted", "energies { shares { name: 'a,b' } }", "is named `a,b`");
  expect_refused("predicted", "energies { shares { name: 'a' } shares { name: 'a' } }", "two shares");
}

TEST(Answers, Relaxation) {
  const auto relaxation = [](const std::string& text) { return "relaxation { " + (kAtRest + text) + " }"; };
  expect_sound("predicted", relaxation("unbalanced_force: 1 internal_force: 2 drag_x: inf net_x: -1"));
  expect_refused("predicted", relaxation("unbalanced_force: -1"), "unbalanced_force is -1");
  expect_refused("predicted", relaxation("drag_y: nan"), "drag_y is nan");
  expect_refused("predicted", relaxation("largest_displacement: -1"), "largest_displacement is -1");
  expect_refused("predicted", relaxation("net_x: inf"), "predicted.relaxation.net_x is inf");
  expect_refused("predicted", "relaxation { unbalanced_force: 1 elements: 1 }", "of no points");
  expect_refused("predicted", "relaxation { internal_force: 1 points: 1 }", "of no elements");
}

TEST(Answers, Bye) {
  expect_sound("bye", "figures { name: 'oval_lining_m' value: nan }");
  expect_refused("bye", "cpu_seconds: -1", "cpu_seconds is -1");
  expect_sound("bye", "crack_paths { cracks: 2 length: 1 opening: 0 slip: 0 x: -1 }");
  for (const std::string figure : {"length", "opening", "slip"})
    expect_refused("bye", "crack_paths { " + figure + ": -1 }", figure + " is -1");
  expect_refused("bye", "crack_paths { opening: nan }", "crack_paths[0].opening is nan");
}

}  // namespace
}  // namespace adit::coupler::answers_test
