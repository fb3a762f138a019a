#include "coupler/recording/diff.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace adit::coupler::difference_test {
namespace {

wire::Frame predicted() {
  wire::Frame frame;
  for (const double velocity : {0.0, 0.1, 0.2}) frame.mutable_predicted()->add_velocities(velocity);
  return frame;
}

void expect_difference(wire::Frame a, wire::Frame b, const std::string& field, const std::string& in_a,
                       const std::string& in_b) {
  const auto found = first_difference(a, b);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->field, field);
  EXPECT_EQ(found->a, in_a);
  EXPECT_EQ(found->b, in_b);
}

// One bit of one number is a difference, and the number is named by its place.
TEST(Difference, IsNamedByFieldAndIndex) {
  wire::Frame b = predicted();
  b.mutable_predicted()->set_velocities(1, std::nextafter(0.1, 1.0));
  b.mutable_predicted()->set_velocities(2, 7);
  expect_difference(predicted(), b, "predicted.velocities[1]", "0.1", "0.10000000000000002");
}

TEST(Difference, IsOneOfBits) {
  wire::Frame zero = predicted();
  zero.mutable_predicted()->set_velocities(0, -0.0);
  expect_difference(predicted(), zero, "predicted.velocities[0]", "0", "-0");
  wire::Frame a = predicted(), b = predicted();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  a.mutable_predicted()->set_velocities(2, nan);
  b.mutable_predicted()->set_velocities(2, nan);
  EXPECT_FALSE(first_difference(a, b));
  const auto other = std::bit_cast<double>(std::bit_cast<std::uint64_t>(nan) + 1);
  b.mutable_predicted()->set_velocities(2, other);
  expect_difference(a, b, "predicted.velocities[2]", "nan (0x7ff8000000000000)", "nan (0x7ff8000000000001)");
}

TEST(Difference, MayBeThatSomethingIsThere) {
  wire::Frame more = predicted(), energies = predicted(), answer;
  more.mutable_predicted()->add_velocities(0.3);
  expect_difference(predicted(), more, "predicted.velocities", "3 values", "4 values");
  energies.mutable_predicted()->mutable_energies()->set_kinetic(2);
  expect_difference(predicted(), energies, "predicted.energies", "nothing", "{ kinetic: 2 }");
  answer.mutable_error()->set_message("no");
  expect_difference(predicted(), answer, "the message", "predicted", "error: no");
}

TEST(Difference, MayLieDeepInAScene) {
  wire::Frame a, b;
  for (wire::Frame* frame : {&a, &b}) {
    frame->mutable_setup()->mutable_scene()->mutable_particles()->add_loads()->mutable_force()->set_x(1);
    frame->mutable_setup()->mutable_scene()->mutable_material()->set_density(2500);
  }
  EXPECT_FALSE(first_difference(a, b));
  b.mutable_setup()->mutable_scene()->mutable_particles()->mutable_loads(0)->mutable_force()->set_x(2);
  expect_difference(a, b, "setup.scene.particles.loads[0].force.x", "1", "2");
}

TEST(Difference, OfBytesIsTheFirstByte) {
  wire::Frame a, b;
  a.mutable_restore()->set_data("abc");
  b.mutable_restore()->set_data("abd!");
  expect_difference(a, b, "restore.data, byte 2", "0x63", "0x64");
  b.mutable_restore()->set_data("abcd");
  expect_difference(a, b, "restore.data, byte 3", "the end", "0x64");
}

// A field of a newer release is compared, too, though its name is not known.
TEST(Difference, MayBeInAFieldOfAnotherRelease) {
  wire::Frame a = predicted(), b = predicted();
  b.mutable_predicted()->GetReflection()->MutableUnknownFields(b.mutable_predicted())->AddVarint(999, 1);
  expect_difference(a, b, "predicted, fields of another release", "0 bytes", "3 bytes");
}

// Clocks and names do not make two runs different.
TEST(Difference, IsNotThatOfClocksAndNames) {
  wire::Frame a = predicted(), b = predicted();
  a.mutable_predicted()->set_compute_seconds(1);
  b.mutable_predicted()->set_hidden_seconds(2);
  EXPECT_FALSE(first_difference(a, b));
  a.mutable_setup()->set_run_id("a/b");
  b.mutable_setup()->mutable_scene()->set_name("other");
  b.mutable_setup()->mutable_scene()->set_description("other");
  a.mutable_setup()->mutable_scene();
  EXPECT_FALSE(first_difference(a, b));
  a.mutable_interface()->set_resident_bytes(1);
  b.mutable_interface();
  EXPECT_FALSE(first_difference(a, b));
  a.mutable_state()->set_data("a");
  b.mutable_state()->set_data("b");
  b.mutable_state()->set_checksum(1);
  EXPECT_FALSE(first_difference(a, b));
  a.mutable_bye()->set_cpu_seconds(1);
  b.mutable_bye();
  EXPECT_FALSE(first_difference(a, b));
  a.mutable_model()->set_state_format("fdm_server 1");
  b.mutable_model();
  EXPECT_FALSE(first_difference(a, b));
}

}  // namespace
}  // namespace adit::coupler::difference_test
