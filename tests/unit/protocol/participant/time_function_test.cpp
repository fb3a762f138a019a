#include "protocol/participant/time_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/refusals.hpp"

namespace adit::protocol::time_function_test {
namespace {

scene::TimeFunction table(const std::vector<double>& times, const std::vector<double>& values) {
  scene::TimeFunction function;
  function.mutable_table()->mutable_time()->Add(times.begin(), times.end());
  function.mutable_table()->mutable_value()->Add(values.begin(), values.end());
  return function;
}

TEST(TimeFunction, IsOneWhereNothingIsGiven) {
  EXPECT_EQ(evaluate(scene::TimeFunction(), 7), 1);
}

TEST(TimeFunction, ConstantIsTheSameAtAllTimes) {
  scene::TimeFunction function;
  function.set_constant(-2.5);
  EXPECT_EQ(evaluate(function, 0), -2.5);
  EXPECT_EQ(evaluate(function, 1e9), -2.5);
}

// Linear between the points, the first value before them, the last after them.
TEST(TimeFunction, TableInterpolatesAndHoldsItsEnds) {
  const auto function = table({1, 2, 4}, {10, 20, 0});
  EXPECT_EQ(evaluate(function, 0), 10);
  EXPECT_EQ(evaluate(function, 1), 10);
  EXPECT_DOUBLE_EQ(evaluate(function, 1.25), 12.5);
  EXPECT_EQ(evaluate(function, 2), 20);
  EXPECT_DOUBLE_EQ(evaluate(function, 3), 10);
  EXPECT_EQ(evaluate(function, 4), 0);
  EXPECT_EQ(evaluate(function, 5), 0);
  EXPECT_EQ(evaluate(table({1}, {3}), 0), 3);
}

TEST(TimeFunction, SineStopsAfterItsEnd) {
  scene::TimeFunction function;
  function.mutable_sine()->set_frequency(50);
  EXPECT_EQ(evaluate(function, 0), 0);
  EXPECT_DOUBLE_EQ(evaluate(function, 0.005), 1);
  EXPECT_NEAR(evaluate(function, 100.005), 1, 1e-9);
  function.mutable_sine()->set_phase(std::numbers::pi / 2);
  function.mutable_sine()->set_end(0.01);
  EXPECT_DOUBLE_EQ(evaluate(function, 0), 1);
  EXPECT_DOUBLE_EQ(evaluate(function, 0.01), -1);
  EXPECT_EQ(evaluate(function, std::nextafter(0.01, 1)), 0);
}

TEST(TimeFunction, TablesThatCannotBeEvaluatedAreRefusedAtTheirPath) {
  const auto refused = [](const scene::TimeFunction& function, const std::string& path,
                          const std::string& text) {
    test::expect_refusal([&] { check_rules(function, "loads[0].time"); }, "loads[0].time.table" + path, text);
  };
  EXPECT_NO_THROW(check_rules(scene::TimeFunction()));
  EXPECT_NO_THROW(check_rules(table({0, 1}, {5, 6})));
  refused(table({}, {}), ".time", "is missing");
  refused(table({0, 1}, {5}), ".value", "has 1 elements, expected 2, as many as `time`");
  refused(table({0, 2, 1}, {5, 6, 7}), ".time[2]", "is 1 s, expected more than the 2 s before it");
  refused(table({0, 1, 1}, {5, 6, 7}), ".time[2]", "is 1 s, expected more than the 1 s before it");
}

}  // namespace
}  // namespace adit::protocol::time_function_test
