// The plane in square cells, wrapped round a torus of about as many cells as there are things in the plane:
// it needs no limits, however far a thing flies, and neighbours in the plane stay neighbours in memory. A
// cell of the torus holds what lies in several of the plane, which are told apart by their true numbers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace adit::dem {

class Torus {
 public:
  // Cells of the given side [m]; thing i is at (x[i], y[i]).
  Torus(double side, std::span<const double> x, std::span<const double> y);

  // visit(other) for what lies in the thing's cell and the eight around: all that is nearer than a side.
  template <class Visit>
  void visit_around(std::uint32_t thing, Visit&& visit) const {
    const Cell own = cells_[thing];
    for (std::int32_t y = own.y - 1; y <= own.y + 1; ++y)
      for (std::int32_t x = own.x - 1; x <= own.x + 1; ++x) {
        const std::size_t k = place({x, y});
        for (std::uint32_t at = starts_[k]; at < starts_[k + 1]; ++at)
          if (cells_[held_[at]] == Cell{x, y}) visit(held_[at]);
      }
  }

 private:
  struct Cell {
    std::int32_t x, y;
    bool operator==(const Cell&) const = default;
  };
  std::size_t place(const Cell& cell) const {
    const auto x = static_cast<std::uint32_t>(cell.x) & (width_ - 1);
    const auto y = static_cast<std::uint32_t>(cell.y) & (height_ - 1);
    return std::size_t{y} * width_ + x;
  }

  std::uint32_t width_, height_;              // powers of two
  std::vector<Cell> cells_;                   // of each thing, in the plane
  std::vector<std::uint32_t> starts_, held_;  // what each cell of the torus holds, by compressed rows
};

}  // namespace adit::dem
