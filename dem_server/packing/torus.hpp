// The plane in square cells, wrapped round a torus of about as many cells as there are things in the plane:
// it needs no limits, however far a thing flies, and neighbours in the plane stay neighbours in memory. A
// cell of the torus holds what lies in several of the plane, which are told apart by their true numbers.
#pragma once

#include <algorithm>
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
    const Cell from = cell_of(x - reach, y - reach), to = cell_of(x + reach, y + reach);
    for (std::int32_t row = from.y; row <= to.y; ++row) visit_row(row, from.x, to.x, visit);
  }
  // Of these, visit_beside(thing) for what lies in the row of cells of (x, y), visit_above(thing) for what
  // lies in rows above: each two things meet once, or twice where they are beside each other.
  template <class VisitBeside, class VisitAbove>
  void visit_onwards(double x, double y, double reach, VisitBeside&& visit_beside,
                     VisitAbove&& visit_above) const {
    const Cell from = cell_of(x - reach, y), to = cell_of(x + reach, y + reach);
    visit_row(from.y, from.x, to.x, visit_beside);
    for (std::int32_t row = from.y + 1; row <= to.y; ++row) visit_row(row, from.x, to.x, visit_above);
  }

 private:
  struct Cell {
    std::int32_t x, y;
  };
  struct Held {
    Cell cell;  // in the plane
    std::uint32_t thing;
  };
  Cell cell_of(double x, double y) const;
  // Cells side by side lie in one piece, up to where the torus begins anew.
  template <class Visit>
  void visit_row(std::int32_t y, std::int32_t from, std::int32_t to, Visit&& visit) const {
    for (std::int32_t x = from, last; x <= to; x = last + 1) {
      last = std::min(to, x | static_cast<std::int32_t>(width_ - 1));
      const std::uint32_t end = starts_[place({last, y}) + 1];
      for (std::uint32_t at = starts_[place({x, y})]; at < end; ++at) {
        const auto& [cell, thing] = held_[at];
        if (cell.y == y && x <= cell.x && cell.x <= last) visit(thing);
      }
    }
  }
  std::size_t place(const Cell& cell) const {
    const auto x = static_cast<std::uint32_t>(cell.x) & (width_ - 1);
    const auto y = static_cast<std::uint32_t>(cell.y) & (height_ - 1);
    return std::size_t{y} * width_ + x;
  }

  double side_;                        // [m]
  std::uint32_t width_, height_;       // powers of two
  std::vector<std::uint32_t> starts_;  // of each cell of the torus, among what all cells hold; and the end
  std::vector<Held> held_;
};

}  // namespace adit::dem
