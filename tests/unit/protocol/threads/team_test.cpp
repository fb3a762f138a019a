// Requirements on threads that share work.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

#include "protocol/threads/team.hpp"

namespace adit::protocol::test::team_test {
namespace {

// Every task is done once a call, all before the call returns, whether tasks or threads are more.
TEST(Team, DoesEveryTaskOnce) {
  for (const std::size_t threads : {1u, 2u, 3u, 5u}) {
    Team team(threads);
    EXPECT_EQ(team.threads(), threads);
    for (const std::size_t count : {0u, 1u, 2u, 7u, 100u}) {
      std::vector<int> done(count, 0);
      for (int call = 1; call <= 50; ++call) {
        team.run(count, [&](std::size_t task, std::size_t) { ++done[task]; });
        ASSERT_THAT(done, testing::Each(call)) << threads << " threads";
      }
    }
  }
}

// A thread always gets the same tasks, next to one another: its data stay in its cache.
TEST(Team, GivesAThreadTheSameShareOfTasks) {
  Team team(3);
  std::vector<std::size_t> first(10), again(10);
  team.run(10, [&](std::size_t task, std::size_t thread) { first[task] = thread; });
  team.run(10, [&](std::size_t task, std::size_t thread) { again[task] = thread; });
  EXPECT_EQ(first, again);
  EXPECT_TRUE(std::ranges::is_sorted(first));
  EXPECT_EQ(std::ranges::count(first, 0u), 3);
}

// Threads that fell asleep between two calls wake up for the next.
TEST(Team, WakesUp) {
  Team team(2);
  for (int call = 0; call < 3; ++call) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::vector<std::size_t> thread_of(2);
    team.run(2, [&](std::size_t task, std::size_t thread) { thread_of[task] = thread; });
    EXPECT_THAT(thread_of, testing::ElementsAre(0, 1));
  }
}

}  // namespace
}  // namespace adit::protocol::test::team_test
