#include "protocol/scatter/factor_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

#include "protocol/errors.hpp"
#include "protocol/foundation/columns.hpp"

namespace adit::protocol {
namespace {

constexpr double kRounding = 1e-9;  // of the lattice's extent: nodes of one line differ by less

// Where the lines stand across one axis, from the coordinates of all nodes.
std::vector<double> lines_of(std::vector<double> coordinates) {
  std::ranges::sort(coordinates);
  const double rounding = kRounding * (coordinates.back() - coordinates.front());
  std::vector<double> lines;
  for (const double at : coordinates)
    if (lines.empty() || at - lines.back() > rounding) lines.push_back(at);
  return lines;
}

// The last line that is not beyond a place.
std::size_t line_before(const std::vector<double>& lines, double at) {
  const auto after = std::ranges::upper_bound(lines, at);
  return after == lines.begin() ? 0 : static_cast<std::size_t>(after - lines.begin()) - 1;
}

// Two lines, and how far a place is from the first to the second one.
struct Between {
  std::size_t first, second;
  double share;
};

Between lines_around(const std::vector<double>& lines, double at) {
  const std::size_t first = line_before(lines, at), second = std::min(first + 1, lines.size() - 1);
  if (first == second) return {first, second, 0};
  return {first, second, std::clamp((at - lines[first]) / (lines[second] - lines[first]), 0.0, 1.0)};
}

// The rows of the table in the order of the nodes, row by row.
std::vector<std::size_t> in_order(std::span<const std::size_t> node, std::span<const double> x_lines,
                                  std::span<const double> y_lines, const std::string& file) {
  std::vector<std::size_t> order(node.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t row) { return node[row]; });
  const auto refuse = [&](std::size_t number, const char* what) {
    throw UserError("",
                    fmt::format("{}: the node at ({:g}, {:g}) m {}", file, x_lines[number % x_lines.size()],
                                y_lines[number / x_lines.size()], what));
  };
  for (std::size_t k = 0; k < order.size(); ++k)
    if (const std::size_t found = node[order[k]]; found < k)
      refuse(found, "stands in two rows; give each node once");
    else if (found > k)
      refuse(k, "has no row; give a factor for every x at every y");
  if (const std::size_t nodes = x_lines.size() * y_lines.size(); order.size() < nodes)
    refuse(order.size(), "has no row; give a factor for every x at every y");
  return order;
}

}  // namespace

FactorField::FactorField(const std::string& file, const std::string& content) {
  const std::array<std::string, 3> names{"x_m", "y_m", "factor"};
  const auto columns = foundation::read_columns(file, content, names);
  const auto &x = columns[0], &y = columns[1], &factors = columns[2];
  for (std::size_t row = 0; row < factors.size(); ++row)
    if (!(factors[row] > 0))
      throw UserError("", fmt::format("{}: the factor at ({:g}, {:g}) m is {:g}; give one above 0", file,
                                      x[row], y[row], factors[row]));
  x_ = lines_of(x);
  y_ = lines_of(y);
  std::vector<std::size_t> node;
  for (std::size_t row = 0; row < factors.size(); ++row)
    node.push_back(line_before(y_, y[row]) * x_.size() + line_before(x_, x[row]));
  for (const std::size_t row : in_order(node, x_, y_, file)) factors_.push_back(factors[row]);
}

double FactorField::at(double x, double y) const {
  const Between column = lines_around(x_, x), row = lines_around(y_, y);
  const auto along = [&](std::size_t line) {
    const double* factors = &factors_[line * x_.size()];
    return std::lerp(factors[column.first], factors[column.second], column.share);
  };
  return std::lerp(along(row.first), along(row.second), row.share);
}

}  // namespace adit::protocol
