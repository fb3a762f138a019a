// Requirements on the steps of every participant (wire.proto, Advance): the order in which they are computed,
// what is refused, what statics leave behind, when peaks are taken and what may come after the answer.
#include "protocol/participant/stepped_participant.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "protocol/errors.hpp"

namespace adit::protocol::stepped_participant_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kDt = 0.5, kMass = 2, kForce = 8;

// A point mass under a steady force, with one coupling point at its place. It notes what it is asked for.
class PointMass : public SteppedParticipant {
 public:
  void set_up(const wire::Setup&, wire::Model&) override {}
  void weigh(const wire::Weights&, wire::Interface&) override {}
  void couple(const wire::Couple&, wire::Operator&) override { points_ = 1; }
  void finish(wire::Bye&) override {}

  std::vector<std::string> calls;
  std::vector<double> peaks;  // velocities that entered them

 private:
  void note(const std::string& call) { calls.push_back(call); }

  std::size_t coupling_points() const override { return points_; }
  void correct(std::span<const double> impulses) override {
    note("correct");
    velocity_ += impulses[0] / kMass;
  }
  void measure_unrest(const Step& last, wire::Relaxation& answer) override {
    note(fmt::format("measure_unrest {}", last.number));
    answer.set_unbalanced_force(kMass * velocity_ / last.kick());
  }
  double kinetic_energy() const override { return kMass * velocity_ * velocity_ / 2; }
  void stop() override {
    note("stop");
    velocity_ = 0;
  }
  void slow(double factor) override {
    note(fmt::format("slow {}", factor));
    velocity_ *= factor;
  }
  void excavate(std::uint32_t stage) override { note(fmt::format("excavate {}", stage)); }
  void scale_masses(bool scaled) override { note(scaled ? "scale_masses" : "true_masses"); }
  void start_over(const Drift& /*drift*/) override {
    note("start_over");
    velocity_ = 0;
  }
  void remember_for_peaks() override { note("remember_for_peaks"); }
  void take_peaks(const Step& step) override {
    note(fmt::format("take_peaks {}", step.number));
    peaks.push_back(velocity_);
  }
  void condense_solver(const wire::Condense& request, wire::Condensed& condensed) override {
    note(fmt::format("condense {}", request.masters()));
    condensed.add_stiffness(1);
  }
  void follow(const Step& step, const wire::Following& masters) override {
    note(fmt::format("follow {}", step.number));
    velocity_ = masters.velocities(0);
  }
  double arrive(const Step& step) override {
    note(fmt::format("arrive {}", step.number));
    return 0.25;
  }
  void go_on() override { note("go_on"); }
  void prepare(const Step& step, const wire::Advance&) override {
    note(fmt::format("prepare {}", step.number));
  }
  void step_interface(const Step& step) override {
    note(fmt::format("step_interface {}", step.number));
    velocity_ += step.kick() * kForce / kMass;
  }
  void step_interior(const Step& step) override { note(fmt::format("step_interior {}", step.number)); }
  void read_velocities(std::span<double> velocities) const override {
    if (!velocities.empty()) velocities[0] = velocity_;
  }
  void read_energies(const Step&, wire::Energies& energies) override {
    energies.set_kinetic(kinetic_energy());
  }
  void read_histories(const Step& step, google::protobuf::RepeatedField<double>& values) override {
    values.Add(step.time());
  }
  void draw(wire::Snapshot& snapshot) override {
    note("draw");
    snapshot.add_pieces()->add_points(velocity_);
  }

  std::size_t points_ = 0;
  double velocity_ = 0;
};

// A run of it, asked as the coupler asks.
struct PointRun {
  PointMass participant;
  Conversation conversation{participant};
  wire::Frame reply;

  explicit PointRun(bool coupled = true) {
    wire::Frame request;
    request.mutable_setup()->mutable_scene()->mutable_time()->set_duration(1);
    conversation.answer(request, reply);
    request.mutable_weights();
    conversation.answer(request, reply);
    if (!coupled) return;
    request.mutable_couple();
    conversation.answer(request, reply);
  }

  const wire::Predicted& advance(const wire::Advance& advance) {
    participant.calls.clear();
    wire::Frame request;
    *request.mutable_advance() = advance;
    conversation.answer(request, reply);
    return reply.predicted();
  }
  double draw(std::initializer_list<double> impulses = {}) {
    participant.calls.clear();
    wire::Frame request;
    request.mutable_snapshot_request()->mutable_impulses()->Assign(impulses.begin(), impulses.end());
    conversation.answer(request, reply);
    return reply.snapshot().pieces(0).points(0);
  }
  std::vector<std::string> rest() {
    participant.calls.clear();
    conversation.complete();
    return participant.calls;
  }
};

wire::Advance step(std::uint64_t number, std::initializer_list<double> impulses = {}) {
  wire::Advance advance;
  advance.set_step(number);
  advance.set_dt(kDt);
  advance.mutable_impulses()->Assign(impulses.begin(), impulses.end());
  return advance;
}

wire::Advance relaxing(std::uint64_t number, std::initializer_list<double> impulses = {}) {
  wire::Advance advance = step(number, impulses);
  advance.set_relax(true);
  return advance;
}

// Impulses belong to the step before: they come first, and what the step overwrites is remembered after them.
TEST(SteppedParticipant, CorrectsBeforeItSteps) {
  PointRun run;
  run.advance(step(0));
  EXPECT_THAT(run.participant.calls, ElementsAre("prepare 0", "step_interface 0"));
  EXPECT_EQ(run.reply.predicted().velocities(0), kDt / 2 * kForce / kMass) << "half a kick from rest";
  run.conversation.complete();
  const double predicted = run.advance(step(1, {6, 0})).velocities(0);
  EXPECT_THAT(run.participant.calls, ElementsAre("correct", "prepare 1", "step_interface 1"));
  EXPECT_EQ(predicted, (kDt / 2 + kDt) * kForce / kMass + 6 / kMass);
}

// A coupled participant computes the rest of a step after its answer, unless something needs all of it.
TEST(SteppedParticipant, LeavesTheInteriorUntilTheAnswerWasSent) {
  PointRun run;
  run.advance(step(0));
  EXPECT_THAT(run.rest(), ElementsAre("step_interior 0"));
  EXPECT_THAT(run.rest(), ElementsAre()) << "once";

  wire::Advance energies = step(1), histories = step(2);
  energies.set_want_energies(true);
  histories.set_want_histories(true);
  for (const wire::Advance& wanted : {energies, histories}) {
    run.advance(wanted);
    EXPECT_EQ(run.participant.calls.back(), fmt::format("step_interior {}", wanted.step()));
    EXPECT_THAT(run.rest(), ElementsAre());
  }
  EXPECT_THAT(run.reply.predicted().histories(), ElementsAre(2 * kDt));

  PointRun alone(false);
  EXPECT_EQ(alone.advance(step(0)).velocities_size(), 0);
  EXPECT_EQ(alone.participant.calls.back(), "step_interior 0") << "nobody waits for the answer";
}

// Peaks are those of final velocities: after the correction, which comes with the next step or a snapshot.
TEST(SteppedParticipant, TakesPeaksOfTheCorrectedStep) {
  PointRun run;
  wire::Advance wanted = step(0);
  wanted.set_want_peaks(true);
  run.advance(wanted);
  EXPECT_THAT(run.participant.calls, ElementsAre("prepare 0", "remember_for_peaks", "step_interface 0"));
  run.draw();
  EXPECT_THAT(run.participant.peaks, ElementsAre()) << "the correction may still come";
  run.draw({6, 0});
  EXPECT_THAT(run.participant.calls, ElementsAre("correct", "take_peaks 0", "draw"));
  const double corrected = kDt / 2 * kForce / kMass + 6 / kMass;
  EXPECT_THAT(run.participant.peaks, ElementsAre(corrected));
  run.draw();
  EXPECT_EQ(run.participant.peaks.size(), 1u) << "a step enters once";

  wanted.set_step(1);
  run.advance(wanted);
  run.advance(step(2, {2, 0}));
  EXPECT_THAT(run.participant.peaks, ElementsAre(corrected, corrected + kDt * kForce / kMass + 2 / kMass));
  run.advance(step(3, {2, 0}));
  EXPECT_EQ(run.participant.peaks.size(), 2u) << "step 2 was not wanted";
}

// Without a coupling there is no correction to wait for.
TEST(SteppedParticipant, TakesPeaksInASnapshotWhereItIsAlone) {
  PointRun alone(false);
  wire::Advance wanted = step(0);
  wanted.set_want_peaks(true);
  alone.advance(wanted);
  alone.draw();
  EXPECT_THAT(alone.participant.calls, ElementsAre("take_peaks 0", "draw"));
}

// Statics: the unrest is that of the corrected step before, a stop comes after it and before the step.
TEST(SteppedParticipant, RelaxesInTheOrderOfTheWire) {
  PointRun run;
  EXPECT_EQ(run.advance(relaxing(0)).relaxation().unbalanced_force(), 0);
  const double velocity = kDt / 2 * kForce / kMass;
  EXPECT_EQ(run.reply.predicted().relaxation().kinetic_energy(), kMass * velocity * velocity / 2);
  EXPECT_EQ(run.participant.calls.back(), "step_interior 0") << "the energy is that of the whole";

  wire::Advance stopping = relaxing(1, {6, 0});
  stopping.set_stop(true);
  stopping.set_stage(2);
  stopping.set_scale_masses(true);
  const wire::Relaxation& relaxation = run.advance(stopping).relaxation();
  EXPECT_THAT(run.participant.calls,
              ElementsAre("correct", "measure_unrest 0", "stop", "excavate 2", "scale_masses", "prepare 1",
                          "step_interface 1", "step_interior 1"));
  EXPECT_EQ(relaxation.unbalanced_force(), kMass * (velocity + 6 / kMass) / (kDt / 2));
  EXPECT_EQ(relaxation.kinetic_energy(), kMass * velocity * velocity / 2) << "from rest, half a kick";
}

// The impulses that come with the first step of time correct the last one of statics, and leave no trace:
// time starts from rest with them as without.
TEST(SteppedParticipant, TimeStartsFromRestWhateverCorrectsTheLastStepOfStatics) {
  PointRun with, without;
  for (PointRun* run : {&with, &without}) {
    run->advance(relaxing(0));
    run->advance(relaxing(1, {6, 0}));
  }
  with.advance(step(0, {6, 0}));
  without.advance(step(0));
  EXPECT_THAT(with.participant.calls,
              ElementsAre("correct", "start_over", "true_masses", "prepare 0", "step_interface 0"));
  EXPECT_THAT(without.participant.calls,
              ElementsAre("start_over", "true_masses", "prepare 0", "step_interface 0"));
  EXPECT_EQ(with.reply.predicted().velocities(0), kDt / 2 * kForce / kMass);
  EXPECT_EQ(without.reply.predicted().velocities(0), kDt / 2 * kForce / kMass);
  with.rest();
  with.advance(step(1, {6, 0}));
  EXPECT_THAT(with.participant.calls, ElementsAre("correct", "prepare 1", "step_interface 1")) << "once";
}

// Statics: what slows the motion takes its share after the correction, and before the step.
TEST(SteppedParticipant, SlowsTheCorrectedMotion) {
  PointRun run;
  run.advance(relaxing(0));
  wire::Advance slowing = relaxing(1, {6, 0});
  slowing.set_slowing(0.25);
  const double before = kDt / 2 * kForce / kMass + 6 / kMass;
  EXPECT_EQ(run.advance(slowing).velocities(0), 0.75 * before + kDt * kForce / kMass);
  EXPECT_THAT(run.participant.calls,
              ElementsAre("correct", "measure_unrest 0", "slow 0.75", "excavate 0", "true_masses",
                          "prepare 1", "step_interface 1", "step_interior 1"));
}

void expect_refused(PointRun& run, const wire::Advance& advance, const std::string& text) {
  try {
    run.advance(advance);
    FAIL() << "accepted, instead of: " << text;
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), HasSubstr(text));
    EXPECT_THAT(run.participant.calls, ElementsAre()) << "nothing is computed";
  }
}

TEST(SteppedParticipant, RefusesImpulsesBeforeTheFirstStep) {
  for (const wire::Advance& first : {step(0, {1, 2}), relaxing(0, {1, 2})}) {
    PointRun run;
    expect_refused(run, first, "before the first step");
  }
}

TEST(SteppedParticipant, RefusesImpulsesThatDoNotFitTheCouplingPoints) {
  PointRun coupled, alone(false);
  for (PointRun* run : {&coupled, &alone}) run->advance(step(0));
  for (PointRun* run : {&coupled, &alone}) run->conversation.complete();
  expect_refused(coupled, step(1, {1, 2, 3}), "3 impulse components came for 1 coupling points");
  expect_refused(alone, step(1, {1, 2}), "2 impulse components came for 0 coupling points");
}

// What a snapshot corrected is final.
TEST(SteppedParticipant, RefusesToCorrectAStepTwice) {
  PointRun run;
  run.advance(step(0));
  run.draw({1, 2});
  expect_refused(run, step(1, {1, 2}), "twice to correct step 0");
  EXPECT_THROW(run.draw({1, 2}), RequestError);
  run.advance(step(1));
  run.advance(step(2, {1, 2}));
}

TEST(SteppedParticipant, RefusesATimeStepThatIsNoTimeStep) {
  const auto expect = [](double dt, const std::string& text) {
    PointRun run;
    wire::Advance first = step(0);
    first.set_dt(dt);
    expect_refused(run, first, text);
  };
  for (const double dt : {0.0, -kDt}) expect(dt, "send a positive number");
  for (const double dt : {std::nan(""), std::numeric_limits<double>::infinity()})
    expect(dt, "must be finite");
}

// dt is one number in statics and another one in time, where the scene has substeps.
TEST(SteppedParticipant, RefusesATimeStepThatChanges) {
  const auto longer = [](wire::Advance advance) {
    advance.set_dt(2 * kDt);
    return advance;
  };
  PointRun run;
  run.advance(relaxing(0));
  run.rest();
  run.participant.calls.clear();
  expect_refused(run, longer(relaxing(1)), "dt is 1 s, but it was 0.5 s in the step before");
  run.advance(longer(step(0)));
  run.rest();
  expect_refused(run, step(1), "dt is 0.5 s, but it was 1 s in the step before");
  run.advance(longer(step(1)));
}

TEST(SteppedParticipant, RefusesStopStageAndScaledMassesOutsideStatics) {
  wire::Advance stopping = step(0), excavating = step(0), scaling = step(0);
  stopping.set_stop(true);
  excavating.set_stage(1);
  scaling.set_scale_masses(true);
  for (const wire::Advance& advance : {stopping, excavating, scaling}) {
    PointRun run;
    expect_refused(run, advance, "came without `relax`");
  }
}

TEST(SteppedParticipant, RefusesASlowingThatIsNoShare) {
  for (const double share : {-0.1, 1.1}) {
    PointRun run;
    wire::Advance advance = relaxing(0);
    advance.set_slowing(share);
    expect_refused(run, advance, "send a share of at most 1");
  }
  PointRun run;
  wire::Advance advance = step(0);
  advance.set_slowing(0.5);
  expect_refused(run, advance, "with `relax` only");
}

// A momentum of other masses means nothing.
TEST(SteppedParticipant, RefusesOtherMassesInMotion) {
  PointRun run;
  wire::Advance scaling = relaxing(1);
  scaling.set_scale_masses(true);
  run.advance(relaxing(0));
  run.rest();
  run.participant.calls.clear();
  expect_refused(run, scaling, "`scale_masses` changed without `stop`");
  scaling.set_stop(true);
  run.advance(scaling);
}

// A model with one coupling point, which follows two masters.
wire::Frame condensing(std::vector<std::uint32_t> row_starts = {0, 2},
                       std::vector<std::uint32_t> columns = {0, 1}, std::uint32_t masters = 2) {
  wire::Frame request;
  wire::Condense& condense = *request.mutable_condense();
  condense.set_masters(masters);
  condense.mutable_row_starts()->Add(row_starts.begin(), row_starts.end());
  condense.mutable_columns()->Add(columns.begin(), columns.end());
  for (std::size_t k = 0; k < columns.size(); ++k) condense.add_values(0.5);
  return request;
}

wire::Advance following(std::uint64_t step, int numbers = 4) {
  wire::Advance advance;
  advance.set_step(step);
  advance.set_dt(kDt);
  for (int k = 0; k < numbers; ++k) {
    advance.mutable_follow()->add_displacements(0);
    advance.mutable_follow()->add_velocities_before(0);
    advance.mutable_follow()->add_velocities(3);
  }
  return advance;
}

TEST(SteppedParticipant, WaitsAndFollowsItsMastersUntilItGoesOn) {
  PointRun run;
  run.conversation.answer(condensing(), run.reply);
  EXPECT_EQ(run.reply.condensed().stiffness(0), 1);
  EXPECT_THAT(run.participant.calls, ElementsAre("condense 2"));
  const wire::Predicted& told = run.advance(following(0));
  EXPECT_EQ(told.demand(), 0.25);
  EXPECT_EQ(told.velocities(0), 3);
  EXPECT_THAT(run.participant.calls, ElementsAre("follow 0", "prepare 0", "arrive 0"));
  wire::Advance seen = following(7);  // steps in between are not told
  seen.set_want_peaks(true);
  run.advance(seen);
  EXPECT_THAT(run.participant.calls, ElementsAre("follow 7", "prepare 7", "remember_for_peaks", "arrive 7"));
  wire::Advance next;
  next.set_step(8);
  next.set_dt(kDt);
  run.advance(next);
  EXPECT_THAT(run.participant.calls, ElementsAre("go_on", "take_peaks 7", "prepare 8", "step_interface 8"));
  EXPECT_EQ(run.reply.predicted().velocities(0), 3 + kDt * kForce / kMass);
}

TEST(SteppedParticipant, WaitsFromTheEndOfStatics) {
  PointRun run;
  wire::Advance relax;
  relax.set_dt(kDt);
  relax.set_relax(true);
  run.advance(relax);
  run.participant.calls.clear();
  run.conversation.answer(condensing(), run.reply);
  EXPECT_THAT(run.participant.calls, ElementsAre("start_over", "true_masses", "condense 2"));
  EXPECT_EQ(run.advance(following(0)).demand(), 0.25);
}

TEST(SteppedParticipant, RefusesMastersThatDoNotFit) {
  for (const auto& request :
       {condensing({0}), condensing({0, 1}), condensing({1, 2}), condensing({0, 2}, {0, 2}),
        condensing({0, 2}, {0, 0}, 0), condensing({0, 2}, {0, 1}, 3)}) {
    PointRun run;
    EXPECT_THROW(run.conversation.answer(request, run.reply), RequestError);
  }
  std::vector<std::uint32_t> many(10'000);  // whose matrices would take gigabytes
  for (std::uint32_t k = 0; k < many.size(); ++k) many[k] = k;
  PointRun huge;
  EXPECT_THROW(huge.conversation.answer(condensing({0, 10'000}, many, 10'000), huge.reply), RequestError);
  PointRun run;
  EXPECT_THROW(run.advance(following(0)), RequestError);  // it does not wait
  PointRun waiting;
  waiting.conversation.answer(condensing(), waiting.reply);
  waiting.advance(following(0));
  EXPECT_THROW(waiting.advance(following(1, 3)), RequestError);
  wire::Advance pushed = following(1);
  pushed.add_impulses(1);
  pushed.add_impulses(1);
  EXPECT_THROW(waiting.advance(pushed), RequestError);
  waiting.advance(following(5));
  EXPECT_THROW(waiting.advance(following(5)), RequestError);  // again
}

}  // namespace
}  // namespace adit::protocol::stepped_participant_test
