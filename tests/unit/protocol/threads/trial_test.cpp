// Requirements on the choice whether threads share the work of a run.
#include "protocol/threads/team.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace adit::protocol::test::trial_test {
namespace {

constexpr int kManySteps = 1000;

// A step after which the next one begins at once.
void take(double seconds, Trial& trial) {
  trial.take(seconds, seconds);
}

// A run whose steps take so long, shared and alone, and are so far apart [s]: whether the last was shared.
bool shares_at_last(double shared, double alone, double pause = 0) {
  Trial trial;
  for (int step = 0; step < kManySteps; ++step) {
    const double seconds = trial.shares() ? shared : alone;
    trial.take(seconds, seconds + pause);
  }
  return trial.shares();
}

// Two threads never make a run slower than one.
TEST(Trial, KeepsTheFaster) {
  EXPECT_TRUE(shares_at_last(1.0, 1.9));
  EXPECT_FALSE(shares_at_last(1.2, 1.0));
  EXPECT_FALSE(shares_at_last(1.0, 1.0));  // it would take a core for nothing
}

// Threads of a model that the run does not wait for would only disturb the one that it waits for.
TEST(Trial, DoesNotShareWhatIsWaitedForNoLongerThanOthers) {
  EXPECT_TRUE(shares_at_last(1.0, 1.9, 1.0));
  EXPECT_FALSE(shares_at_last(1.0, 1.9, 2.0));
}

// Other processes of a run need the cores, too: what counts is how long steps mostly take.
TEST(Trial, IsNotMisledBySomeShortSteps) {
  Trial trial;
  for (int step = 0; step < kManySteps; ++step)
    take(!trial.shares() ? 1.0 : step % 5 == 0 ? 0.6 : 1.7, trial);
  EXPECT_FALSE(trial.shares());
}

// Steps that other work of the machine made longer decide nothing, as long as it disturbs both kinds alike.
TEST(Trial, IsNotMisledBySomeLongSteps) {
  for (const bool faster : {false, true}) {
    Trial trial;
    for (int step = 0; step < kManySteps; ++step) {
      const bool disturbed = step % 3 != 0;
      take((disturbed ? 50.0 : 1.0) * (trial.shares() == faster ? 1.0 : 1.9), trial);
    }
    EXPECT_EQ(trial.shares(), faster);
  }
}

// The choice is made in few steps, and then kept.
TEST(Trial, EndsSoon) {
  Trial trial;
  for (int step = 0; step < 50; ++step) take(trial.shares() ? 2.0 : 1.0, trial);
  EXPECT_FALSE(trial.shares());
  for (int step = 0; step < kManySteps; ++step) {
    take(100.0, trial);
    EXPECT_FALSE(trial.shares());
  }
}

// A team that does not pay works alone.
TEST(Trial, RulesItsTeam) {
  Team team(2);
  const auto threads_used = [&] {
    std::vector<std::size_t> thread_of(2);
    team.run(2, [&](std::size_t task, std::size_t thread) { thread_of[task] = thread; });
    return std::set(thread_of.begin(), thread_of.end()).size();
  };
  EXPECT_EQ(threads_used(), 2);
  for (int step = 0; step < kManySteps; ++step) team.took(threads_used() == 2 ? 2.0 : 1.0);
  EXPECT_EQ(threads_used(), 1);
}

}  // namespace
}  // namespace adit::protocol::test::trial_test
