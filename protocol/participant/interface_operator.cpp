#include "protocol/participant/interface_operator.hpp"

#include <algorithm>

namespace adit::protocol {

InterfaceOperator::InterfaceOperator(std::span<const OperatorRow> rows) {
  for (const OperatorRow& row : rows) {
    for (std::size_t e = 0; e < row.shares.size(); ++e) {
      if (row.shares[e] == 0) continue;
      columns_.push_back(row.points[e]);
      values_.push_back(row.shares[e]);
    }
    row_starts_.push_back(static_cast<std::uint32_t>(columns_.size()));
  }
  points_ = columns_;
  std::ranges::sort(points_);
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  for (auto& column : columns_)
    column = static_cast<std::uint32_t>(std::ranges::lower_bound(points_, column) - points_.begin());
  identity_ = this->rows() == points_.size() && std::ranges::is_sorted(columns_) &&
              std::ranges::all_of(values_, [](double value) { return value == 1; });
  gathered_.resize(2 * points_.size());
}

void InterfaceOperator::fill(wire::Operator& op) const {
  op.mutable_row_starts()->Assign(row_starts_.begin(), row_starts_.end());
  op.mutable_columns()->Assign(columns_.begin(), columns_.end());
  op.mutable_values()->Assign(values_.begin(), values_.end());
}

std::span<const double> InterfaceOperator::gather(std::span<const double> impulses) {
  if (identity_) return impulses;
  std::ranges::fill(gathered_, 0.0);
  for (std::size_t k = 0; k < rows(); ++k)
    for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e) {
      gathered_[2 * columns_[e]] += values_[e] * impulses[2 * k];
      gathered_[2 * columns_[e] + 1] += values_[e] * impulses[2 * k + 1];
    }
  return gathered_;
}

void InterfaceOperator::velocities(std::span<const double> vx, std::span<const double> vy,
                                   std::span<double> result) const {
  if (identity_) {
    for (std::size_t k = 0; k < points_.size(); ++k) {
      result[2 * k] = vx[points_[k]];
      result[2 * k + 1] = vy[points_[k]];
    }
    return;
  }
  for (std::size_t k = 0; k < rows(); ++k) {
    double x = 0, y = 0;
    for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e) {
      const std::uint32_t point = points_[columns_[e]];
      x += values_[e] * vx[point];
      y += values_[e] * vy[point];
    }
    result[2 * k] = x;
    result[2 * k + 1] = y;
  }
}

}  // namespace adit::protocol
