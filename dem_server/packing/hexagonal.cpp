#include "dem_server/packing/hexagonal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::dem {
namespace {

// Whole pieces of `size` in `length`, forgiving the rounding of lengths such as 9 sqrt(3) R.
double pieces(double length, double size) {
  return std::max(0.0, std::floor(length / size + 1e-6));
}

double rows_in(const Rectangle& box, double radius) {
  return pieces(box.y_max - box.y_min, std::numbers::sqrt3 * radius);
}

double discs_in(const Rectangle& box, double radius) {
  return pieces(box.x_max - box.x_min, 2 * radius);
}

// Links of `row` (which starts at particle `start`) along the row and to the row above, if there is one.
void link_row(bool wide, std::uint32_t start, std::uint32_t count, std::uint32_t count_above,
              std::vector<Link>& links) {
  const std::uint32_t above = start + count;
  for (std::uint32_t k = 0; k + 1 < count; ++k)
    links.push_back({start + k, start + k + 1, Direction::kAlongRow});
  if (count_above == 0) return;
  // A wide row's disc k has disc k of the row above at its right and k - 1 at its left; a narrow row's has
  // k + 1 and k.
  for (std::uint32_t k = 0; k < count; ++k)
    if (const std::uint32_t right = wide ? k : k + 1; right < count_above)
      links.push_back({start + k, above + right, Direction::kUpRight});
  for (std::uint32_t k = wide ? 1 : 0; k < count; ++k)
    if (const std::uint32_t left = wide ? k - 1 : k; left < count_above)
      links.push_back({start + k, above + left, Direction::kUpLeft});
}

}  // namespace

double count_hexagonal(const Rectangle& box, double radius) {
  const double rows = rows_in(box, radius), wide = discs_in(box, radius);
  return wide > 0 ? std::ceil(rows / 2) * wide + std::floor(rows / 2) * (wide - 1) : 0.0;
}

Packing pack_hexagonally(const Rectangle& box, double radius) {
  const double pitch = std::numbers::sqrt3 * radius;
  const auto rows = static_cast<std::uint32_t>(rows_in(box, radius));
  const auto wide_count = static_cast<std::uint32_t>(discs_in(box, radius));
  const double half_width = wide_count * radius, half_height = 0.5 * rows * pitch;
  const double middle_x = 0.5 * (box.x_min + box.x_max), middle_y = 0.5 * (box.y_min + box.y_max);
  Packing packing{
      radius,
      {middle_x - half_width, middle_x + half_width, middle_y - half_height, middle_y + half_height},
      {},
      {},
      {}};
  const auto count_in = [&](std::uint32_t row) {
    if (row >= rows || wide_count == 0) return 0u;
    return row % 2 == 0 ? wide_count : wide_count - 1;
  };
  for (std::uint32_t row = 0; row < rows; ++row) {
    const auto start = static_cast<std::uint32_t>(packing.x.size());
    const std::uint32_t count = count_in(row);
    for (std::uint32_t k = 0; k < count; ++k) {
      packing.x.push_back(packing.cells.x_min + (2 * k + (row % 2 == 0 ? 1 : 2)) * radius);
      packing.y.push_back(packing.cells.y_min + (row + 0.5) * pitch);
    }
    link_row(row % 2 == 0, start, count, count_in(row + 1), packing.links);
  }
  return packing;
}

std::array<double, 2> rest_vector(Direction direction, double radius) {
  switch (direction) {
    case Direction::kAlongRow:
      return {2 * radius, 0};
    case Direction::kUpRight:
      return {radius, std::numbers::sqrt3 * radius};
    case Direction::kUpLeft:
      return {-radius, std::numbers::sqrt3 * radius};
  }
  return {0, 0};
}

}  // namespace adit::dem
