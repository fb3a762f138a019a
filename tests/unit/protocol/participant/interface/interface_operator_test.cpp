#include "protocol/participant/interface/interface_operator.hpp"

#include <gmock/gmock.h>

namespace adit::protocol::interface_operator_test {
namespace {

using testing::ElementsAre;

// Three coupling points: one is point 7, one lies between 7 and 2, one among all of 2, 5 and 9.
InterfaceOperator example() {
  const std::vector<OperatorRow> rows{
      {{7, 0, 0, 0}, {1, 0, 0, 0}}, {{7, 5, 2, 9}, {0.25, 0, 0.75, 0}}, {{9, 2, 5, 7}, {1.5, -1, 0.5, 0}}};
  return InterfaceOperator(rows);
}

// Only what takes part is named, and nothing that is 0.
TEST(InterfaceOperator, FillsTheMessageWithoutZeros) {
  wire::Operator op;
  example().fill(op);
  EXPECT_THAT(example().points(), ElementsAre(2, 5, 7, 9));
  EXPECT_THAT(op.row_starts(), ElementsAre(0, 1, 3, 6));
  EXPECT_THAT(op.columns(), ElementsAre(2, 2, 0, 3, 0, 1));
  EXPECT_THAT(op.values(), ElementsAre(1, 0.25, 0.75, 1.5, -1, 0.5));
}

// Velocities are N v, and what impulses do is N^T p: the work of a pair of them is the same on either side.
TEST(InterfaceOperator, GathersByTheTransposeOfWhatItInterpolates) {
  InterfaceOperator op = example();
  const std::vector<double> vx{0, 0, 3, 0, 0, -2, 0, 5, 0, 7}, vy{0, 0, 1, 0, 0, 4, 0, -6, 0, 2};
  const std::vector<double> impulses{1, -2, 4, 8, 3, 5};
  std::vector<double> velocities(6);
  op.velocities(vx, vy, velocities);
  EXPECT_THAT(velocities, ElementsAre(5, -6, 3.5, -0.75, 6.5, 4));
  for (int twice = 0; twice < 2; ++twice) {
    const auto own = op.gather(impulses);
    double here = 0, there = 0;
    for (std::size_t i = 0; i < 6; ++i) there += impulses[i] * velocities[i];
    for (std::size_t j = 0; j < op.points().size(); ++j)
      here += own[2 * j] * vx[op.points()[j]] + own[2 * j + 1] * vy[op.points()[j]];
    EXPECT_DOUBLE_EQ(here, there);
  }
}

// Coupling points that are the participant's own, in its order or in another, twice or once, move with those
// alone.
TEST(InterfaceOperator, SelectsOwnPoints) {
  const std::vector<double> vx{10, 11, 12, 13}, vy{20, 21, 22, 23}, impulses{1, 2, 3, 4, 5, 6};
  std::vector<double> velocities(6);
  const auto select = [&](const std::vector<std::uint32_t>& points) {
    std::vector<OperatorRow> rows;
    for (const std::uint32_t point : points) rows.push_back({{point}, {1.0}});
    InterfaceOperator op(rows);
    op.velocities(vx, vy, velocities);
    const auto own = op.gather(impulses);
    return std::vector<double>(own.begin(), own.end());
  };
  EXPECT_THAT(select({0, 1, 3}), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(velocities, ElementsAre(10, 20, 11, 21, 13, 23));
  EXPECT_THAT(select({3, 0, 1}), ElementsAre(3, 4, 5, 6, 1, 2));
  EXPECT_THAT(velocities, ElementsAre(13, 23, 10, 20, 11, 21));
  EXPECT_THAT(select({1, 1, 2}), ElementsAre(4, 6, 5, 6));
  EXPECT_THAT(velocities, ElementsAre(11, 21, 11, 21, 12, 22));
}

// A run without coupling points has no rows.
TEST(InterfaceOperator, IsEmptyAtFirst) {
  InterfaceOperator op;
  EXPECT_EQ(op.rows(), 0u);
  EXPECT_TRUE(op.gather({}).empty());
}

}  // namespace
}  // namespace adit::protocol::interface_operator_test
