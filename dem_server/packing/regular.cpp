#include "dem_server/packing/regular.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::dem {
namespace {

// Whole pieces of `size` in `length`, forgiving the rounding of lengths such as 9 sqrt(3) R.
double pieces(double length, double size) {
  return std::max(0.0, std::floor(length / size + 1e-6));
}

double rows_in(const geometry::BoundingBox& box, double radius) {
  return pieces(box.y_max - box.y_min, std::numbers::sqrt3 * radius);
}

double discs_in(const geometry::BoundingBox& box, double radius) {
  return pieces(box.x_max - box.x_min, 2 * radius);
}

}  // namespace

double count_hexagonal(const geometry::BoundingBox& box, double radius) {
  const double rows = rows_in(box, radius), wide = discs_in(box, radius);
  return wide > 0 ? std::ceil(rows / 2) * wide + std::floor(rows / 2) * (wide - 1) : 0.0;
}

HexagonalLattice pack_hexagonally(const geometry::BoundingBox& box, double radius) {
  const double pitch = std::numbers::sqrt3 * radius;
  const auto rows = static_cast<std::uint32_t>(rows_in(box, radius));
  const auto wide_count = static_cast<std::uint32_t>(discs_in(box, radius));
  const double half_width = wide_count * radius, half_height = 0.5 * rows * pitch;
  const double middle_x = 0.5 * (box.x_min + box.x_max), middle_y = 0.5 * (box.y_min + box.y_max);
  HexagonalLattice lattice{
      {}, {middle_x - half_width, middle_x + half_width, middle_y - half_height, middle_y + half_height}};
  if (wide_count == 0) return lattice;
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t k = row % 2; k < wide_count; ++k) {
      lattice.discs.x.push_back(lattice.cells.x_min + (2 * k + (row % 2 == 0 ? 1 : 0)) * radius);
      lattice.discs.y.push_back(lattice.cells.y_min + (row + 0.5) * pitch);
      lattice.discs.radius.push_back(radius);
    }
  return lattice;
}

Discs pack_squarely(const geometry::BoundingBox& box, double radius) {
  // forgiving the rounding of lengths such as 20 * 0.05
  const auto whole = [radius](double length) { return std::floor(length / (2 * radius) + 1e-6); };
  const double columns = whole(box.x_max - box.x_min), rows = whole(box.y_max - box.y_min);
  const double x = 0.5 * (box.x_min + box.x_max) - (columns - 1) * radius;
  const double y = 0.5 * (box.y_min + box.y_max) - (rows - 1) * radius;
  Discs discs;
  for (double j = 0; j < rows; ++j)
    for (double i = 0; i < columns; ++i) {
      discs.x.push_back(x + 2 * i * radius);
      discs.y.push_back(y + 2 * j * radius);
      discs.radius.push_back(radius);
    }
  return discs;
}

}  // namespace adit::dem
