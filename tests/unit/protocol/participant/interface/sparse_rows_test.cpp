#include "protocol/participant/interface/sparse_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace adit::protocol::sparse_rows_test {
namespace {

constexpr std::size_t kOwn = 12;

struct Row {
  std::vector<std::uint32_t> columns;
  std::vector<double> values;
};

// Rows of one to six entries, most of four; those that follow one another often have the same columns.
std::vector<Row> random_rows(std::mt19937& random, std::size_t count) {
  std::vector<Row> rows;
  for (std::size_t k = 0; k < count; ++k) {
    Row row;
    if (k > 0 && random() % 3 != 0) {
      row.columns = rows.back().columns;
    } else {
      std::vector<std::uint32_t> all(kOwn);
      for (std::uint32_t i = 0; i < kOwn; ++i) all[i] = i;
      std::ranges::shuffle(all, random);
      row.columns.assign(all.begin(), all.begin() + (random() % 2 == 0 ? 4 : 1 + random() % 6));
    }
    for (std::size_t e = 0; e < row.columns.size(); ++e)
      row.values.push_back(std::uniform_real_distribution(-1.0, 1.0)(random));
    rows.push_back(row);
  }
  return rows;
}

SparseRows matrix_of(const std::vector<Row>& rows) {
  std::vector<std::uint32_t> starts{0}, columns;
  std::vector<double> values;
  for (const Row& row : rows) {
    columns.insert(columns.end(), row.columns.begin(), row.columns.end());
    values.insert(values.end(), row.values.begin(), row.values.end());
    starts.push_back(static_cast<std::uint32_t>(columns.size()));
  }
  return {starts, columns, values};
}

std::vector<double> random_values(std::mt19937& random, std::size_t count) {
  std::vector<double> values(count);
  for (double& value : values) value = std::normal_distribution(0.0, 1.0)(random);
  return values;
}

// To the bit, whichever rows are taken together.
TEST(SparseRows, ActAsRowByRow) {
  std::mt19937 random(5);
  for (const std::size_t count : {0, 1, 2, 7, 100, 1000}) {
    const std::vector<Row> rows = random_rows(random, count);
    const SparseRows matrix = matrix_of(rows);
    const auto own = random_values(random, 2 * kOwn), impulses = random_values(random, 2 * count);
    std::vector<double> velocities(2 * count), gathered(2 * kOwn, 1.0);
    matrix.interpolate(own, velocities);
    matrix.gather(impulses, gathered);
    std::vector<double> expected(2 * kOwn, 0.0);
    for (std::size_t k = 0; k < count; ++k)
      for (const std::size_t c : {0, 1}) {
        double velocity = 0;
        for (std::size_t e = 0; e < rows[k].columns.size(); ++e) {
          velocity += rows[k].values[e] * own[2 * rows[k].columns[e] + c];
          expected[2 * rows[k].columns[e] + c] += rows[k].values[e] * impulses[2 * k + c];
        }
        EXPECT_EQ(velocities[2 * k + c], velocity) << "row " << k << " of " << count;
      }
    EXPECT_EQ(gathered, expected);
  }
}

}  // namespace
}  // namespace adit::protocol::sparse_rows_test
