#include "protocol/participant/time_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "protocol/errors.hpp"

namespace adit::protocol {
namespace {

scene::TimeFunction table(const std::vector<double>& times, const std::vector<double>& values) {
  scene::TimeFunction function;
  function.mutable_table()->mutable_time()->Add(times.begin(), times.end());
  function.mutable_table()->mutable_value()->Add(values.begin(), values.end());
  return function;
}

std::string faulty_path(const scene::TimeFunction& function) {
  try {
    check(function, "loads[0].time");
    return {};
  } catch (const UserError& error) {
    return error.path();
  }
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
  EXPECT_EQ(faulty_path(scene::TimeFunction()), "");
  EXPECT_EQ(faulty_path(table({0, 1}, {5, 6})), "");
  EXPECT_EQ(faulty_path(table({}, {})), "loads[0].time.table.time");
  EXPECT_EQ(faulty_path(table({0, 1}, {5})), "loads[0].time.table");
  EXPECT_EQ(faulty_path(table({0, 2, 1}, {5, 6, 7})), "loads[0].time.table.time");
  EXPECT_EQ(faulty_path(table({0, 1, 1}, {5, 6, 7})), "loads[0].time.table.time");
}

}  // namespace
}  // namespace adit::protocol
