#include "protocol/participant/interface/interface_operator.hpp"

#include <algorithm>
#include <utility>

#include "protocol/messages/wire.pb.h"

namespace adit::protocol {

InterfaceOperator::InterfaceOperator(std::span<const OperatorRow> rows) {
  std::vector<std::uint32_t> row_starts{0}, columns;
  std::vector<double> values;
  for (const OperatorRow& row : rows) {
    for (std::size_t e = 0; e < row.shares.size(); ++e) {
      if (row.shares[e] == 0) continue;
      columns.push_back(row.points[e]);
      values.push_back(row.shares[e]);
    }
    row_starts.push_back(static_cast<std::uint32_t>(columns.size()));
  }
  points_ = columns;
  std::ranges::sort(points_);
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  for (auto& column : columns)
    column = static_cast<std::uint32_t>(std::ranges::lower_bound(points_, column) - points_.begin());
  identity_ = rows.size() == points_.size() && std::ranges::is_sorted(columns) &&
              std::ranges::all_of(values, [](double value) { return value == 1; });
  n_ = SparseRows(std::move(row_starts), std::move(columns), std::move(values));
  own_.resize(2 * points_.size());
}

void InterfaceOperator::fill(wire::Operator& op) const {
  op.mutable_row_starts()->Assign(n_.row_starts().begin(), n_.row_starts().end());
  op.mutable_columns()->Assign(n_.columns().begin(), n_.columns().end());
  op.mutable_values()->Assign(n_.values().begin(), n_.values().end());
}

std::span<const double> InterfaceOperator::gather(std::span<const double> impulses) {
  if (identity_) return impulses;
  n_.gather(impulses, own_);
  return own_;
}

void InterfaceOperator::velocities(std::span<const double> vx, std::span<const double> vy,
                                   std::span<double> result) const {
  const std::span<double> own = identity_ ? result : std::span(own_);
  for (std::size_t j = 0; j < points_.size(); ++j) {
    own[2 * j] = vx[points_[j]];
    own[2 * j + 1] = vy[points_[j]];
  }
  if (!identity_) n_.interpolate(own, result);
}

}  // namespace adit::protocol
