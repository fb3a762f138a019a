#include "protocol/geometry/cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adit::protocol {
namespace {

std::size_t cell_of(double value, double min, double side, std::size_t count) {
  const double index = std::clamp(std::floor((value - min) / side), 0.0, static_cast<double>(count - 1));
  return static_cast<std::size_t>(index);
}

Extent around(std::span<const Extent> things) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Extent all{kFar, -kFar, kFar, -kFar};
  for (const Extent& thing : things)
    all = {std::min(all.x_min, thing.x_min), std::max(all.x_max, thing.x_max),
           std::min(all.y_min, thing.y_min), std::max(all.y_max, thing.y_max)};
  return all;
}

}  // namespace

Cells::Cells(std::span<const Extent> things, double side) : side_(side) {
  if (things.empty()) return;
  const Extent all = around(things);
  x_min_ = all.x_min;
  y_min_ = all.y_min;
  columns_ = static_cast<std::size_t>((all.x_max - all.x_min) / side) + 1;
  rows_ = static_cast<std::size_t>((all.y_max - all.y_min) / side) + 1;
  const auto for_each_cell = [&](const Extent& thing, auto&& visit) {
    const Range across = columns(thing.x_min, thing.x_max), up = rows(thing.y_min, thing.y_max);
    for (std::size_t j = up.first; j <= up.last; ++j)
      for (std::size_t i = across.first; i <= across.last; ++i) visit(j * columns_ + i);
  };
  starts_.assign(columns_ * rows_ + 1, 0);
  for (const Extent& thing : things) for_each_cell(thing, [&](std::size_t cell) { ++starts_[cell + 1]; });
  for (std::size_t cell = 0; cell < columns_ * rows_; ++cell) starts_[cell + 1] += starts_[cell];
  things_.resize(starts_.back());
  auto next = starts_;
  for (std::uint32_t thing = 0; thing < things.size(); ++thing)
    for_each_cell(things[thing], [&](std::size_t cell) { things_[next[cell]++] = thing; });
}

std::span<const std::uint32_t> Cells::at(double x, double y) const {
  return in_cell(rows(y, y).first * columns_ + columns(x, x).first);
}

Cells::Range Cells::columns(double low, double high) const {
  return {cell_of(low, x_min_, side_, columns_), cell_of(high, x_min_, side_, columns_)};
}

Cells::Range Cells::rows(double low, double high) const {
  return {cell_of(low, y_min_, side_, rows_), cell_of(high, y_min_, side_, rows_)};
}

std::span<const std::uint32_t> Cells::in_cell(std::size_t cell) const {
  return std::span(things_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
}

}  // namespace adit::protocol
