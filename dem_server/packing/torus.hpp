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

  // visit(thing) for what lies in the cells that reach into the square of half side `reach` [m] around (x,
  // y): all that is nearer than that.
  template <class Visit>
  void visit_near(double x, double y, double reach, Visit&& visit) const {
    visit_cells(cell_of(x - reach, y - reach), cell_of(x + reach, y + reach), visit);
  }

 private:
  struct Cell {
    std::int32_t x, y;
    bool operator==(const Cell&) const = default;
  };
  Cell cell_of(double x, double y) const;
  template <class Visit>
  void visit_cells(const Cell& from, const Cell& to, Visit&& visit) const {
    for (std::int32_t y = from.y; y <= to.y; ++y)
      for (std::int32_t x = from.x; x <= to.x; ++x) {
        const std::size_t k = place({x, y});
        for (std::uint32_t at = starts_[k]; at < starts_[k + 1]; ++at)
          if (cells_[held_[at]] == Cell{x, y}) visit(held_[at]);
      }
  }
  std::size_t place(const Cell& cell) const {
    const auto x = static_cast<std::uint32_t>(cell.x) & (width_ - 1);
    const auto y = static_cast<std::uint32_t>(cell.y) & (height_ - 1);
    return std::size_t{y} * width_ + x;
  }

  double side_;                               // [m]
  std::uint32_t width_, height_;              // powers of two
  std::vector<Cell> cells_;                   // of each thing, in the plane
  std::vector<std::uint32_t> starts_, held_;  // what each cell of the torus holds, by compressed rows
};

}  // namespace adit::dem
