// Objects in the plane, sorted into square cells. A search by place looks into a few cells only, whatever the
// number of objects.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace adit::protocol {

// An axis-parallel rectangle around a thing [m].
struct Extent {
  double x_min, x_max, y_min, y_max;
};

class Cells {
 public:
  Cells() = default;
  // Sorts the things, numbered from 0, into cells of the given side [m]. A thing is listed in every cell that
  // it meets.
  Cells(std::span<const Extent> things, double side);

  // The things listed in the cell of (x, y), or in the cell nearest to it, ascending.
  std::span<const std::uint32_t> at(double x, double y) const;

  // Calls visit(thing) for all things within `reach` of (x, y). It also visits some that are farther away,
  // and some more than once.
  template <class Visit>
  void visit_near(double x, double y, double reach, Visit&& visit) const {
    const Range across = columns(x - reach, x + reach), up = rows(y - reach, y + reach);
    for (std::size_t j = up.first; j <= up.last; ++j)
      for (std::size_t i = across.first; i <= across.last; ++i)
        for (const std::uint32_t thing : in_cell(j * columns_ + i)) visit(thing);
  }

 private:
  struct Range {
    std::size_t first, last;
  };
  Range columns(double low, double high) const;
  Range rows(double low, double high) const;
  std::span<const std::uint32_t> in_cell(std::size_t cell) const;

  double side_ = 1, x_min_ = 0, y_min_ = 0;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> starts_{0, 0};  // where each cell's list begins in things_ (compressed rows)
  std::vector<std::uint32_t> things_;
};

}  // namespace adit::protocol
