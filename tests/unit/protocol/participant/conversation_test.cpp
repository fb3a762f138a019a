#include <gmock/gmock.h>

#include <cmath>
#include <thread>

#include "protocol/errors.hpp"
#include "protocol/participant/participant.hpp"
#include "tests/support/refusals.hpp"

namespace adit::protocol::conversation_test {
namespace {

using testing::HasSubstr;

class Recorder : public Participant {
 public:
  void set_up(const wire::Setup&, wire::Model& model) override { model.set_critical_dt(1); }
  void weigh(const wire::Weights&, wire::Interface& interface) override { interface.set_zones(4); }
  void couple(const wire::Couple&, wire::Operator& op) override { op.add_values(1); }
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override {
    EXPECT_FALSE(predicted.has_energies()) << "answers arrive cleared";
    predicted.set_step(advance.step());
    if (advance.want_energies()) predicted.mutable_energies()->set_strain(strain);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  void snapshot(const wire::SnapshotRequest&, wire::Snapshot& snapshot) override { snapshot.add_pieces(); }
  void finish(wire::Bye& bye) override { bye.set_updates(9); }

  double strain = 0;
};

wire::Frame request(wire::Frame::ContentCase kind, std::uint64_t step = 0) {
  wire::Frame frame;
  const auto* field = wire::Frame::descriptor()->FindFieldByNumber(kind);
  wire::Frame::GetReflection()->MutableMessage(&frame, field);
  if (frame.has_advance()) frame.mutable_advance()->set_step(step);
  if (frame.has_setup()) frame.mutable_setup()->mutable_scene()->mutable_time()->set_duration(1);
  return frame;
}

struct ConversationTest : testing::Test {
  Recorder participant;
  Conversation conversation{participant};
  wire::Frame reply;

  wire::Frame::ContentCase ask(wire::Frame::ContentCase kind, std::uint64_t step = 0) {
    conversation.answer(request(kind, step), reply);
    return reply.content_case();
  }
};

// Every request of a coupled run is answered by the message that wire.proto pairs with it.
TEST_F(ConversationTest, AnswersACoupledRun) {
  EXPECT_EQ(ask(wire::Frame::kSetup), wire::Frame::kModel);
  EXPECT_EQ(ask(wire::Frame::kWeights), wire::Frame::kInterface);
  EXPECT_EQ(ask(wire::Frame::kCouple), wire::Frame::kOperator);
  EXPECT_EQ(ask(wire::Frame::kAdvance, 0), wire::Frame::kPredicted);
  EXPECT_EQ(ask(wire::Frame::kSnapshotRequest), wire::Frame::kSnapshot);
  EXPECT_EQ(ask(wire::Frame::kAdvance, 1), wire::Frame::kPredicted);
  EXPECT_GE(reply.predicted().compute_seconds(), 0.002);
  EXPECT_FALSE(conversation.finished());
  EXPECT_EQ(ask(wire::Frame::kFinish), wire::Frame::kBye);
  EXPECT_TRUE(conversation.finished());
}

TEST_F(ConversationTest, AnswersARunWithoutCoupling) {
  ask(wire::Frame::kSetup);
  ask(wire::Frame::kWeights);
  EXPECT_EQ(ask(wire::Frame::kAdvance, 0), wire::Frame::kPredicted);
}

// Requirement: numbers that are not finite are blamed on the one that sent them.
TEST_F(ConversationTest, RefusesNumbersOfTheCouplerThatAreNotFinite) {
  ask(wire::Frame::kSetup);
  ask(wire::Frame::kWeights);
  auto advance = request(wire::Frame::kAdvance, 0);
  advance.mutable_advance()->add_impulses(NAN);
  EXPECT_THROW(conversation.answer(advance, reply), RequestError);
}

TEST_F(ConversationTest, EndsAStepWhoseNumbersAreNotFinite) {
  participant.strain = INFINITY;
  ask(wire::Frame::kSetup);
  ask(wire::Frame::kWeights);
  auto advance = request(wire::Frame::kAdvance, 0);
  advance.mutable_advance()->set_want_energies(true);
  try {
    conversation.answer(advance, reply);
    FAIL() << "answered";
  } catch (const Unstable& error) {
    EXPECT_THAT(error.what(), HasSubstr("step 0: predicted.energies.strain is inf"));
  }
}

// What was wanted in one step does not stand in the answer to the next.
TEST_F(ConversationTest, AnswersArriveCleared) {
  ask(wire::Frame::kSetup);
  ask(wire::Frame::kWeights);
  auto advance = request(wire::Frame::kAdvance, 0);
  advance.mutable_advance()->set_want_energies(true);
  conversation.answer(advance, reply);
  EXPECT_TRUE(reply.predicted().has_energies());
  ask(wire::Frame::kAdvance, 1);
  EXPECT_FALSE(reply.predicted().has_energies());
}

// Statics come first, with steps of their own; time then begins at step 0, once.
TEST_F(ConversationTest, StaticsComeBeforeTime) {
  const auto advance = [&](std::uint64_t step, bool relax) {
    auto frame = request(wire::Frame::kAdvance, step);
    frame.mutable_advance()->set_relax(relax);
    conversation.answer(frame, reply);
  };
  ask(wire::Frame::kSetup);
  ask(wire::Frame::kWeights);
  advance(0, true);
  EXPECT_THROW(advance(0, true), RequestError);
  advance(1, true);
  EXPECT_THROW(advance(2, false), RequestError);
  advance(0, false);
  EXPECT_THROW(advance(0, false), RequestError);
  EXPECT_THROW(advance(1, true), RequestError);
  advance(1, false);
}

TEST_F(ConversationTest, RefusesWhatIsOutOfOrder) {
  using Kind = wire::Frame::ContentCase;
  const auto refuses = [&](Kind kind, std::uint64_t step = 0) {
    EXPECT_THROW(ask(kind, step), RequestError) << "kind " << kind;
  };
  for (const Kind kind : {Kind::kWeights, Kind::kCouple, Kind::kAdvance, Kind::kSnapshotRequest,
                          Kind::kFinish, Kind::kHello, Kind::kModel}) {
    refuses(kind);
  }
  ask(Kind::kSetup);
  for (const Kind kind : {Kind::kSetup, Kind::kCouple, Kind::kAdvance, Kind::kSnapshotRequest}) refuses(kind);
  ask(Kind::kWeights);
  for (const Kind kind : {Kind::kSetup, Kind::kWeights}) refuses(kind);
  ask(Kind::kAdvance, 0);
  refuses(Kind::kCouple);
  ask(Kind::kFinish);
  for (const Kind kind : {Kind::kSetup, Kind::kAdvance, Kind::kFinish}) refuses(kind);
}

// A scene that breaks a rule never reaches the participant, whoever sent it: the error names the field.
TEST(Conversation, ChecksTheRulesOfTheScene) {
  struct : Recorder {
    void set_up(const wire::Setup&, wire::Model&) override { ADD_FAILURE() << "the scene was not checked"; }
  } participant;
  Conversation conversation(participant);
  wire::Frame setup = request(wire::Frame::kSetup), reply;
  auto& packing = *setup.mutable_setup()->mutable_scene()->mutable_particles()->mutable_packing();
  packing.set_radius(-1);
  test::expect_refusal([&] { conversation.answer(setup, reply); }, "particles.packing.radius",
                       "is -1 m, expected a length above 0 m");
  packing.set_radius(1);
  test::expect_refusal([&] { conversation.answer(setup, reply); }, "particles.packing.x_min", "is missing");
}

// Leaves the rest of every step, which takes a while, to complete().
class Deferrer : public Recorder {
 public:
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override {
    EXPECT_EQ(completed, asked++) << "step " << advance.step() << " finds the one before whole";
    predicted.set_step(advance.step());
  }
  void complete() override {
    ++completed;
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    if (unstable) throw Unstable("not finite");
  }
  int asked = 0, completed = 0;
  bool unstable = false;
};

struct DeferringConversation : testing::Test {
  Deferrer participant;
  Conversation conversation{participant};
  wire::Frame reply;

  void SetUp() override {
    for (const auto kind : {wire::Frame::kSetup, wire::Frame::kWeights, wire::Frame::kCouple})
      conversation.answer(request(kind), reply);
  }
  void advance(std::uint64_t step) { conversation.answer(request(wire::Frame::kAdvance, step), reply); }
};

// A step is completed once, after its answer; the next answer says how long that took.
TEST_F(DeferringConversation, CompletesEveryStepOnce) {
  conversation.complete();
  EXPECT_EQ(participant.completed, 0) << "no step yet";
  advance(0);
  EXPECT_EQ(participant.completed, 0) << "the answer comes first";
  EXPECT_EQ(reply.predicted().hidden_seconds(), 0);
  conversation.complete();
  conversation.complete();
  EXPECT_EQ(participant.completed, 1);
  advance(1);
  EXPECT_GE(reply.predicted().hidden_seconds(), 0.003);
  EXPECT_LT(reply.predicted().compute_seconds(), 0.003) << "is not counted twice";
}

// Whatever comes next finds the step whole, also where nobody said that the answer was sent.
TEST_F(DeferringConversation, NothingIsAnsweredFromHalfAStep) {
  advance(0);
  advance(1);
  conversation.answer(request(wire::Frame::kSnapshotRequest), reply);
  EXPECT_EQ(participant.completed, 2);
  advance(2);
  conversation.answer(request(wire::Frame::kFinish), reply);
  EXPECT_EQ(participant.completed, 3);
}

// An error in the rest of a step is the answer to the next request, whichever that is.
TEST_F(DeferringConversation, ErrorsOfTheRestAreTheNextAnswer) {
  participant.unstable = true;
  advance(0);
  EXPECT_NO_THROW(conversation.complete());
  for (const auto kind : {wire::Frame::kSnapshotRequest, wire::Frame::kFinish})
    EXPECT_THROW(conversation.answer(request(kind), reply), Unstable);
  EXPECT_THROW(advance(1), Unstable);
}

// A step that is left out or repeated is named.
TEST_F(ConversationTest, RefusesASkippedStep) {
  ask(wire::Frame::kSetup);
  ask(wire::Frame::kWeights);
  ask(wire::Frame::kAdvance, 0);
  try {
    ask(wire::Frame::kAdvance, 2);
    FAIL() << "accepted";
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), HasSubstr("advance to step 2"));
    EXPECT_THAT(error.what(), HasSubstr("next step: 1"));
  }
}

}  // namespace
}  // namespace adit::protocol::conversation_test
