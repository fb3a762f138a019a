// Requirement: no answer may be longer than the model can need that the participant told of.
#include "coupler/servers/remote_connection.hpp"

#include <gtest/gtest.h>

#include "protocol/wire/bounds.hpp"

namespace adit::coupler::answer_bounds_test {
namespace {

using Frame = wire::Frame;
using protocol::kMaxRunBytes;

wire::Frame model(int samples) {
  wire::Frame frame;
  frame.mutable_model()->mutable_sample_points()->Resize(2 * samples, 0.0);
  return frame;
}

TEST(AnswerBounds, FollowFromTheSamplePoints) {
  constexpr std::uint64_t kSamples = 2'000'000;
  AnswerBounds bounds;
  EXPECT_EQ(bounds.longest(Frame::kSetup), protocol::kMaxModelBytes);
  bounds.answered(model(kSamples));
  EXPECT_EQ(bounds.longest(Frame::kWeights), kMaxRunBytes + 64 * kSamples);
  EXPECT_EQ(bounds.longest(Frame::kSnapshotRequest), kMaxRunBytes + 1024 * kSamples);
  EXPECT_EQ(bounds.longest(Frame::kSave), kMaxRunBytes);
}

// The snapshot of a participant of another code may show more than its samples tell.
TEST(AnswerBounds, LeaveASmallModelTheLongestFrame) {
  AnswerBounds bounds;
  bounds.answered(model(10));
  EXPECT_EQ(bounds.longest(Frame::kSnapshotRequest), protocol::kMaxFrameBytes);
}

// Velocities of all coupling points, and a crack for each bond; a participant may not tell more bonds than
// fit between its sample points.
TEST(AnswerBounds, OfAStepHoldAllVelocitiesAndCracks) {
  AnswerBounds bounds;
  bounds.answered(model(1000));
  wire::Frame frame;
  frame.mutable_interface()->set_bonds(3000);
  bounds.answered(frame);
  frame.mutable_couple()->mutable_points()->Resize(200, 0.0);
  bounds.asked(frame);
  EXPECT_EQ(bounds.longest(Frame::kCouple), kMaxRunBytes + 512 * 200);
  EXPECT_EQ(bounds.longest(Frame::kAdvance), kMaxRunBytes + 8 * 200 + 256 * 3000);
  frame.mutable_interface()->set_bonds(~std::uint64_t{0});
  bounds.answered(frame);
  EXPECT_EQ(bounds.longest(Frame::kAdvance), kMaxRunBytes + 8 * 200 + 256 * 4000);
}

TEST(AnswerBounds, OfACondensedModelHoldTwoTrianglesAndAForce) {
  AnswerBounds bounds;
  wire::Frame frame;
  frame.mutable_condense()->set_masters(300);
  bounds.asked(frame);
  const std::uint64_t numbers = 600 * 601 + 600;  // of stiffness, mass and force
  EXPECT_EQ(bounds.longest(Frame::kCondense), kMaxRunBytes + 8 * numbers + 8 * 600);
}

}  // namespace
}  // namespace adit::coupler::answer_bounds_test
