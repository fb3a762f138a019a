#include "dem_server/packing/torus.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace adit::dem {
namespace {

std::int32_t cell_number(double value, double side) {
  constexpr double kFar = 1 << 30;
  const double cell = std::floor(value / side);
  // NaN fails the comparison and goes to the first cell, so that no cast overflows.
  return static_cast<std::int32_t>(cell > -kFar ? std::min(cell, kFar) : -kFar);
}

}  // namespace

Torus::Cell Torus::cell_of(double x, double y) const {
  return {cell_number(x, side_), cell_number(y, side_)};
}

Torus::Torus(double side, std::span<const double> x, std::span<const double> y) : side_(side) {
  const auto bits = static_cast<std::uint32_t>(std::bit_width(x.size()));
  width_ = std::uint32_t{1} << (bits + 1) / 2;
  height_ = std::uint32_t{1} << bits / 2;
  std::vector<Cell> cells;
  cells.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) cells.push_back(cell_of(x[i], y[i]));
  starts_.assign(std::size_t{width_} * height_ + 1, 0);
  for (const Cell& cell : cells) ++starts_[place(cell) + 1];
  for (std::size_t k = 1; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
  auto next = starts_;
  held_.resize(x.size());
  for (std::uint32_t i = 0; i < x.size(); ++i) held_[next[place(cells[i])]++] = {cells[i], i};
}

}  // namespace adit::dem
