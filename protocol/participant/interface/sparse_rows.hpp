// A sparse matrix N, stored by rows, that acts alike on the x and the y of interleaved pairs: it takes the
// velocities of a participant's own points to the coupling points (wire.proto, Operator).
//
// Coupling points that follow one another often lie in the same zone: rows of the same four columns, whose
// own points are read and written once for all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace adit::protocol {

class SparseRows {
 public:
  SparseRows() = default;
  // Row k has the entries row_starts[k] to row_starts[k + 1] of the other two, which must be there.
  SparseRows(std::vector<std::uint32_t> row_starts, std::vector<std::uint32_t> columns,
             std::vector<double> values);

  std::size_t rows() const { return row_starts_.size() - 1; }
  std::span<const std::uint32_t> columns(std::size_t row) const {
    return std::span(columns_).subspan(row_starts_[row], row_starts_[row + 1] - row_starts_[row]);
  }
  std::span<const double> values(std::size_t row) const {
    return std::span(values_).subspan(row_starts_[row], row_starts_[row + 1] - row_starts_[row]);
  }

  void gather(std::span<const double> impulses, std::span<double> own) const;         // own = Nᵀ impulses
  void interpolate(std::span<const double> own, std::span<double> velocities) const;  // velocities = N own

  // As they are stored.
  std::span<const std::uint32_t> row_starts() const { return row_starts_; }
  std::span<const std::uint32_t> columns() const { return columns_; }
  std::span<const double> values() const { return values_; }

 private:
  // Consecutive rows: of the same four columns, or any.
  struct Run {
    std::size_t begin, end;
    bool same_four;
  };

  std::vector<std::uint32_t> row_starts_{0};
  std::vector<std::uint32_t> columns_;
  std::vector<double> values_;
  std::vector<Run> runs_;
};

}  // namespace adit::protocol
