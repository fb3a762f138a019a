// The grid's side of the constraint: velocity at coupling point k = sum over j of N(k, j) v_j.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fdm_server/continuum.hpp"
#include "fdm_server/grid.hpp"

namespace adit::fdm {

class InterfaceOperator {
 public:
  InterfaceOperator() = default;
  // `points`: coupling points, interleaved [m]. UserError where one lies outside the grid.
  InterfaceOperator(const Grid& grid, std::span<const double> points);

  std::size_t rows() const { return row_starts_.size() - 1; }
  std::span<const std::uint32_t> row_starts() const { return row_starts_; }
  std::span<const std::uint32_t> columns() const { return columns_; }  // into grid_points()
  std::span<const double> values() const { return values_; }
  std::span<const std::uint32_t> grid_points() const { return grid_points_; }  // that take part, ascending

  // Pushes the grid points by N^T impulses, interleaved [N s].
  void apply(std::span<const double> impulses, Continuum& continuum) const;
  // N v, interleaved [m/s].
  void velocities(const Continuum& continuum, std::span<double> result) const;

 private:
  std::vector<std::uint32_t> row_starts_{0};
  std::vector<std::uint32_t> columns_;
  std::vector<double> values_;
  std::vector<std::uint32_t> grid_points_;
};

}  // namespace adit::fdm
