// Requirement: a participant that is restored from a state answers as the one that saved it would have.
#include <gmock/gmock.h>

#include "protocol/errors.hpp"
#include "protocol/participant/participant.hpp"
#include "protocol/wire/bounds.hpp"
#include "tests/support/refusals.hpp"

namespace adit::protocol::restore_test {
namespace {

using testing::HasSubstr;

constexpr int kSamples = 10'000;

// Adds up its steps, and holds so much that its state has several parts.
class Counter : public Participant {
 public:
  explicit Counter(std::string format = "counter 1") : format_(std::move(format)) {}
  void set_up(const wire::Setup&, wire::Model& model) override {
    model.set_critical_dt(1);
    model.mutable_sample_points()->Resize(2 * kSamples, 0.0);
  }
  void weigh(const wire::Weights&, wire::Interface&) override {}
  void couple(const wire::Couple&, wire::Operator&) override {}
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override {
    sum_ += 1.0 / static_cast<double>(advance.step() + 1);
    field_[advance.step()] = sum_;
    predicted.add_velocities(sum_ + field_[advance.step()]);
  }
  void snapshot(const wire::SnapshotRequest&, wire::Snapshot&) override {}
  std::string state_format() const override { return format_; }
  void exchange(state::Archive& archive) override {
    archive("sum", sum_);
    archive("field", std::span(field_));
  }
  void finish(wire::Bye&) override {}

 private:
  std::string format_;
  double sum_ = 0;
  std::vector<double> field_ = std::vector<double>(2'500'000, 0.0);
};

struct Talk {
  Counter participant;
  Conversation conversation{participant};
  wire::Frame reply;

  explicit Talk(std::string format = "counter 1") : participant(std::move(format)) {
    wire::Frame request;
    request.mutable_setup()->mutable_scene()->mutable_time()->set_duration(1);
    conversation.answer(request, reply);
    EXPECT_EQ(reply.model().state_format(), participant.state_format());
    request.mutable_weights();
    conversation.answer(request, reply);
  }

  double advance(std::uint64_t step, bool relax = false) {
    wire::Frame request;
    request.mutable_advance()->set_step(step);
    request.mutable_advance()->set_relax(relax);
    conversation.answer(request, reply);
    return reply.predicted().velocities(0);
  }

  std::vector<wire::State> save() {
    std::vector<wire::State> parts;
    for (std::uint64_t offset = 0; parts.empty() || offset < parts[0].size();) {
      wire::Frame request;
      request.mutable_save()->set_offset(offset);
      conversation.answer(request, reply);
      parts.push_back(reply.state());
      offset += parts.back().data().size();
    }
    return parts;
  }

  void restore(const wire::State& part, std::uint64_t offset) {
    wire::Frame request;
    wire::Restore& restore = *request.mutable_restore();
    restore.set_size(part.size());
    restore.set_offset(offset);
    restore.set_data(part.data());
    restore.set_checksum(part.checksum());
    conversation.answer(request, reply);
    EXPECT_TRUE(reply.has_restored());
  }

  void restore(const std::vector<wire::State>& parts) {
    std::uint64_t offset = 0;
    for (const wire::State& part : parts) {
      restore(part, offset);
      offset += part.data().size();
    }
  }
};

TEST(Restore, GoesOnWhereTheOtherWas) {
  Talk first, second;
  for (std::uint64_t n = 0; n < 3; ++n) first.advance(n);
  const auto parts = first.save();
  EXPECT_GT(parts.size(), 1u);
  second.restore(parts);
  EXPECT_EQ(second.advance(3), first.advance(3));
  EXPECT_THROW(second.advance(3), RequestError) << "it knows its step";
}

// In statics, too: time may begin, or statics go on.
TEST(Restore, KnowsStatics) {
  Talk first, second, third;
  for (std::uint64_t n = 0; n < 3; ++n) first.advance(n, true);
  const auto parts = first.save();
  second.restore(parts);
  third.restore(parts);
  second.advance(3, true);
  third.advance(0);
}

TEST(Restore, RefusesWhatIsOutOfOrder) {
  Talk first;
  first.advance(0);
  const auto parts = first.save();
  EXPECT_THROW(first.restore(parts), RequestError) << "after a step";
  Talk second;
  EXPECT_THROW(second.restore(parts[1], parts[0].data().size()), RequestError) << "without the first part";
  wire::State shorter = parts[0];
  shorter.mutable_data()->pop_back();
  EXPECT_THROW(second.restore(shorter, 0), RequestError);
  wire::Frame request, reply;
  request.mutable_save()->set_offset(8);
  EXPECT_THROW(first.conversation.answer(request, reply), RequestError) << "no part begins there";
}

// A client may announce any size: nothing of it is kept before it is compared with the model.
TEST(Restore, RefusesAStateThatIsTooLargeForTheModel) {
  Talk first, second;
  first.advance(0);
  wire::State part = first.save()[0];
  part.set_size(most_state_bytes(kSamples) + 1);
  EXPECT_THROW(second.restore(part, 0), RequestError);
  part.set_size(most_state_bytes(kSamples));
  EXPECT_NO_THROW(second.restore(part, 0));
}

TEST(Restore, RefusesWhatWasDamaged) {
  Talk first, second;
  first.advance(0);
  auto parts = first.save();
  (*parts[0].mutable_data())[1000] ^= 1;
  test::expect_refusal([&] { second.restore(parts[0], 0); }, "", "damaged");
}

// A participant without states is not asked for any.
TEST(Restore, IsNotForAllParticipants) {
  Talk run("");
  run.advance(0);
  EXPECT_THROW(run.save(), RequestError);
}

}  // namespace
}  // namespace adit::protocol::restore_test
