#include "fdm_server/interface_operator.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fdm_server/locate.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {

InterfaceOperator::InterfaceOperator(const Grid& grid, std::span<const double> points) {
  const ZoneLocator locator(grid);
  for (std::size_t k = 0; 2 * k < points.size(); ++k) {
    const auto place = locator.locate(points[2 * k], points[2 * k + 1]);
    if (!place)
      throw protocol::UserError("interface.overlap",
                                fmt::format("holds the coupling point ({}, {}) m, which lies outside the "
                                            "continuum; let the continuum cover the overlap",
                                            points[2 * k], points[2 * k + 1]));
    for (std::size_t c = 0; c < 4; ++c) {
      if (place->shape[c] == 0) continue;
      columns_.push_back(static_cast<std::uint32_t>(grid.zones[place->zone][c]));
      values_.push_back(place->shape[c]);
    }
    row_starts_.push_back(static_cast<std::uint32_t>(columns_.size()));
  }
  grid_points_ = columns_;
  std::ranges::sort(grid_points_);
  grid_points_.erase(std::unique(grid_points_.begin(), grid_points_.end()), grid_points_.end());
  for (auto& column : columns_)
    column =
        static_cast<std::uint32_t>(std::ranges::lower_bound(grid_points_, column) - grid_points_.begin());
}

void InterfaceOperator::apply(std::span<const double> impulses, Continuum& continuum) const {
  for (std::size_t k = 0; k < rows(); ++k)
    for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e)
      continuum.push(grid_points_[columns_[e]], values_[e] * impulses[2 * k],
                     values_[e] * impulses[2 * k + 1]);
}

void InterfaceOperator::velocities(const Continuum& continuum, std::span<double> result) const {
  const auto vx = continuum.vx(), vy = continuum.vy();
  for (std::size_t k = 0; k < rows(); ++k) {
    double x = 0, y = 0;
    for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e) {
      const auto point = grid_points_[columns_[e]];
      x += values_[e] * vx[point];
      y += values_[e] * vy[point];
    }
    result[2 * k] = x;
    result[2 * k + 1] = y;
  }
}

}  // namespace adit::fdm
