// A participant's side of the constraint (wire.proto, Operator): the velocity at coupling point k is the sum
// over j of N(k, j) v_j, j counting the participant's own points that take part.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "protocol/participant/interface/sparse_rows.hpp"

namespace adit::wire {
class Operator;
}

namespace adit::protocol {

// A coupling point between points of the participant (by its own numbers); shares of 0 do not take part, and
// the others sum to 1.
struct OperatorRow {
  std::array<std::uint32_t, 4> points;
  std::array<double, 4> shares;
};

class InterfaceOperator {
 public:
  InterfaceOperator() = default;
  explicit InterfaceOperator(std::span<const OperatorRow> rows);

  std::size_t rows() const { return n_.rows(); }
  std::span<const std::uint32_t> points() const { return points_; }  // that take part, ascending

  const SparseRows& matrix() const { return n_; }  // its columns are places in points()

  // All of the message but the inverse masses, which belong to points() in their order.
  void fill(wire::Operator& op) const;

  // N^T impulses [N s], one pair for each of points(); valid until the next call, as long as the impulses.
  std::span<const double> gather(std::span<const double> impulses);

  // N v from the velocities of all points of the participant, interleaved [m/s].
  void velocities(std::span<const double> vx, std::span<const double> vy, std::span<double> result) const;

 private:
  SparseRows n_;  // its columns are places in points_
  std::vector<std::uint32_t> points_;
  bool identity_ = false;            // the coupling points are points_ in their order
  mutable std::vector<double> own_;  // scratch: one pair for each of points_
};

}  // namespace adit::protocol
