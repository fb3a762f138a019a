// Requirement: rows of histories.csv come at exactly the interval asked for, at the price of few steps; where
// that is not possible, the user hears how far apart they are. So the user does of every time that acts
// otherwise than stated: from 1 % on in a list, from 5 % on as a warning.
#include "coupler/participants/time_step.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "coupler/check/warnings.hpp"
#include "coupler/output/schedule.hpp"

namespace adit::coupler::step_choice_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(StepChoice, TakesTheFewestStepsThatDivideTheInterval) {
  const Steps steps = dividing_steps(30, 3.8176e-4, 5e-3, {});
  EXPECT_DOUBLE_EQ(steps.dt, 5e-3 / 14);
  EXPECT_EQ(steps.count, 84000U);
}

// 25 ms are no multiple of 10 ms; with an even number of steps an interval both end on a step.
TEST(StepChoice, EndsOnTheDurationWhereATenthMoreStepsDoThat) {
  const Steps steps = dividing_steps(0.025, 1e-3 / 2.1, 0.01, {});
  EXPECT_DOUBLE_EQ(steps.dt, 0.01 / 22);
  EXPECT_EQ(steps.count, 55U);
}

TEST(StepChoice, PutsFieldTimesOnSteps) {
  const std::vector<double> times{0.0125, 0.0375};
  const Steps steps = dividing_steps(0.05, 1e-3 / 2.3, 0.01, times);
  EXPECT_DOUBLE_EQ(steps.dt, 0.01 / 24);
  EXPECT_EQ(steps.count, 120U);
}

TEST(StepChoice, EndsLessThanAStepLaterWhereNothingDividesBoth) {
  const Steps steps = dividing_steps(0.0251234567, 1e-3, 0.01, {});
  EXPECT_DOUBLE_EQ(steps.dt, 1e-3);
  EXPECT_EQ(steps.count, 26U);
}

// A model of one continuum whose critical step is 1 ms.
Model model_with(const std::string& scene) {
  Model model;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(scene, &model.scene));
  model.participants.emplace_back();
  model.participants[0].member = {"continuum", Role::kContinuum, "continuum"};
  model.participants[0].model.set_critical_dt(1e-3);
  choose_time_step(model);
  return model;
}

// The same, with what acts otherwise than stated.
Model compared(const std::string& scene) {
  Model model = model_with(scene);
  compare_time_step(model);
  Schedule(model).compare(model);
  return model;
}

void expect_rows(const std::string& scene, double interval, double dt) {
  const Model model = model_with(scene);
  const Schedule schedule(model);
  EXPECT_NEAR(model.dt, dt, 1e-12) << scene;
  EXPECT_NEAR(schedule.interval(), interval, 1e-12) << scene;
}

// Statics take the steps of statics, where a participant tells one; what it tells not is as in time.
TEST(StaticSteps, AreThoseThatParticipantsTell) {
  Model model;
  for (const auto& [of_time, of_statics] : {std::pair{1e-3, 4e-3}, {2e-3, 0.0}}) {
    model.participants.emplace_back();
    model.participants.back().model.set_critical_dt(of_time);
    model.participants.back().model.set_critical_static_dt(of_statics);
  }
  EXPECT_DOUBLE_EQ(choose_static_steps(model, 0.5, false), 1e-3);
  EXPECT_DOUBLE_EQ(model.participants[0].step_ratio, 1);
  EXPECT_DOUBLE_EQ(choose_static_steps(model, 0.5, true), 1e-3);
  EXPECT_DOUBLE_EQ(model.participants[0].step_ratio, 2);
  EXPECT_DOUBLE_EQ(model.participants[1].step_ratio, 1);
}

TEST(TimeStep, MakesRowsAtTheInterval) {
  expect_rows("time { duration: 1 dt_factor: 0.9 } output { history_interval: 0.05 }", 0.05, 0.05 / 56);
  expect_rows("time { duration: 1 dt_factor: 0.9 } output { history_interval: 0.0013 }", 0.0013, 0.00065);
  expect_rows("time { duration: 1 dt: 0.0005 } output { history_interval: 0.05 }", 0.05, 0.0005);
}

TEST(TimeStep, MakesFiveHundredRowsInLongRuns) {
  expect_rows("time { duration: 30 dt_factor: 0.9 }", 0.06, 0.06 / 67);
  expect_rows("time { duration: 30 dt_factor: 0.9 } output { spectra { shortest_period: 0.5 } }", 0.025,
              0.025 / 28);
}

// In short runs the step is not shortened for rows that nobody asked for.
TEST(TimeStep, KeepsTheStepOfShortRunsWithoutAnInterval) {
  const Model model = model_with("time { duration: 0.6 dt_factor: 0.9 }");
  EXPECT_EQ(model.steps, 667U);
  EXPECT_THAT(model.notes, IsEmpty());
}

// A given step stays; the run ends at most a step later than asked.
TEST(TimeStep, KeepsAGivenStepAndSaysWhereRowsMissTheInterval) {
  Model model = model_with("time { duration: 1.0001 dt: 0.0004 } output { history_interval: 0.002 }");
  EXPECT_DOUBLE_EQ(model.dt, 0.0004);
  EXPECT_EQ(model.steps, 2501U);
  EXPECT_THAT(model.notes, IsEmpty());
  model = compared("time { duration: 1 dt: 0.0004 } output { history_interval: 0.001 }");
  EXPECT_DOUBLE_EQ(model.dt, 0.0004);
  EXPECT_THAT(
      warnings_before(model),
      ElementsAre("`output.history_interval` is stated as 0.001 s, but 0.0012 s acts: `time.dt` makes "
                  "steps of 0.0004 s; choose a multiple of it"));
}

// A stated step acts exactly, whether or not a number of them makes up the duration.
TEST(TimeStep, IsTheStatedOneForAnyDuration) {
  for (const double duration : {0.5, 0.50001, 0.512345}) {
    const Model model = model_with("time { dt: 50e-6 duration: " + std::to_string(duration) + " }");
    EXPECT_EQ(model.dt, 50e-6);
    const double end = static_cast<double>(model.steps) * model.dt;
    EXPECT_GE(end, duration * (1 - 1e-9));
    EXPECT_LT(end, duration + model.dt);
  }
}

// A run that goes on keeps its step, and tells where a new run of its duration would take another.
TEST(TimeStep, OfALengthenedRunIsToldWhereANewRunTakesAnother) {
  Model model = model_with("time { duration: 2 dt_factor: 0.9 }");
  const double step = model.dt;
  keep_time_step(model, step);
  EXPECT_THAT(model.notes, IsEmpty());
  Model longer = model_with("time { duration: 30 dt_factor: 0.9 }");
  keep_time_step(longer, step);
  EXPECT_EQ(longer.dt, step);
  EXPECT_THAT(longer.notes,
              testing::ElementsAre(HasSubstr("a new run of 30 s would take steps of 0.000895522 s")));
}

// Whether or not somebody stated the share of the critical step that the interval takes.
TEST(TimeStep, SaysWhatAnIntervalCosts) {
  Model model = compared("time { duration: 1 } output { history_interval: 0.0006 }");
  EXPECT_DOUBLE_EQ(model.dt, 0.0003);
  EXPECT_THAT(model.notes, ElementsAre(HasSubstr("with 0.001 s the run takes 40 % fewer steps")));
  EXPECT_THAT(model.stated, IsEmpty());
  model = compared("time { duration: 1 dt_factor: 0.9 } output { history_interval: 0.001 }");
  EXPECT_DOUBLE_EQ(model.dt, 0.0005);
  EXPECT_THAT(model.notes, ElementsAre(HasSubstr("with 0.0018 s the run takes 44 % fewer steps")));
  EXPECT_THAT(warnings_before(model), IsEmpty()) << "a shorter step keeps the share";
  model = compared("time { duration: 1 dt_factor: 0.9 } output { history_interval: 0.0001 }");
  EXPECT_NEAR(model.dt, 0.0009, 1e-6);
  EXPECT_THAT(warnings_before(model),
              ElementsAre(AllOf(HasSubstr("`output.history_interval` is stated as 0.0001 s, but 0.0008"),
                                HasSubstr("rows come at whole steps of 0.0008"))));
}

// Nothing is said of what acts as it is stated, nor of what nobody stated.
TEST(Stated, IsNotToldWhereItActs) {
  for (const char* scene :
       {"time { duration: 1 }",
        "time { duration: 1 dt: 0.0004 } output { history_interval: 0.002 field_times: 0.0012 }",
        "time { duration: 1 dt: 0.0003 } output { history_interval: 0.02 field_times: 0.5 }",
        "time { duration: 1 dt: 0.0004 } output { history_interval: 5 field_times: 0 }"}) {
    const Model model = compared(scene);
    EXPECT_THAT(model.stated, IsEmpty()) << scene;
    EXPECT_THAT(warnings_before(model), IsEmpty()) << scene;
  }
}

void expect_told(const std::string& scene, const std::string& key, double stated, double acted,
                 bool warned = true) {
  const Model model = compared(scene);
  ASSERT_EQ(model.stated.size(), 1U) << scene;
  EXPECT_EQ(model.stated[0].key, key);
  EXPECT_DOUBLE_EQ(model.stated[0].stated, stated);
  EXPECT_NEAR(model.stated[0].acted, acted, 1e-12);
  EXPECT_EQ(warnings_before(model).empty(), !warned || std::abs(acted / stated - 1) < 0.05) << scene;
}

TEST(Stated, IsToldWithWhatActs) {
  expect_told("time { duration: 0.0105 dt: 0.001 }", "time.duration", 0.0105, 0.011);
  expect_told("time { duration: 0.0051 dt: 0.001 }", "time.duration", 0.0051, 0.006);
  expect_told("time { duration: 1 dt: 0.001 } output { history_interval: 0.0207 }", "output.history_interval",
              0.0207, 0.021);
  expect_told("time { duration: 1 dt: 0.001 } output { field_times: [0.5, 0.0302, 0.0003] }",
              "output.field_times[2]", 0.0003, 0);
  expect_told("time { duration: 1 dt: 0.001 } output { field_times: 0.0302 field_times: 0.0104 }",
              "output.field_times[1]", 0.0104, 0.01);
  expect_told("time { duration: 1 dt: 0.0005 dt_factor: 0.9 }", "time.dt_factor", 0.9, 0.5);
  expect_told("time { duration: 0.0035 dt_factor: 0.9 }", "time.dt_factor", 0.9, 0.875, false);
  expect_told("time { duration: 1 dt_factor: 0.9 } output { history_interval: 0.001 }", "time.dt_factor", 0.9,
              0.5, false);
}

}  // namespace
}  // namespace adit::coupler::step_choice_test
