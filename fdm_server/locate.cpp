#include "fdm_server/locate.hpp"

#include <algorithm>
#include <cmath>

namespace adit::fdm {
namespace {

constexpr double kTolerance = 1e-9;  // in natural coordinates

// Snaps to the zone's edges, so that a point on an edge depends on that edge's points only.
double snap(double natural) {
  return std::abs(natural) > 1 - kTolerance ? std::copysign(1, natural) : natural;
}

std::size_t cell_of(double value, double min, double cell, std::size_t count) {
  const double index = std::clamp(std::floor((value - min) / cell), 0.0, static_cast<double>(count - 1));
  return static_cast<std::size_t>(index);
}

}  // namespace

std::optional<std::array<double, 2>> inverse_bilinear(const Corners& c, double x, double y) {
  // 4 (x - x0) = a + b xi + c eta + d xi eta: relative to a corner, so that far from the origin no digit is
  // lost
  const auto coefficients = [](const std::array<double, 4>& corner, double first) {
    const double p1 = corner[1] - first, p2 = corner[2] - first, p3 = corner[3] - first;
    return std::array{p1 + p2 + p3, p1 + p2 - p3, p2 + p3 - p1, p2 - p1 - p3};
  };
  const auto px = coefficients(c.x, c.x[0]), py = coefficients(c.y, c.y[0]);
  const double at_x = 4 * (x - c.x[0]), at_y = 4 * (y - c.y[0]);
  double xi = 0, eta = 0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    const double rx = at_x - (px[0] + px[1] * xi + px[2] * eta + px[3] * xi * eta);
    const double ry = at_y - (py[0] + py[1] * xi + py[2] * eta + py[3] * xi * eta);
    const double x_xi = px[1] + px[3] * eta, x_eta = px[2] + px[3] * xi;
    const double y_xi = py[1] + py[3] * eta, y_eta = py[2] + py[3] * xi;
    const double determinant = x_xi * y_eta - x_eta * y_xi;
    const double step_xi = (y_eta * rx - x_eta * ry) / determinant;
    const double step_eta = (x_xi * ry - y_xi * rx) / determinant;
    xi += step_xi;
    eta += step_eta;
    // convergence is quadratic: the step that follows one of 1e-9 is below rounding
    if (std::abs(step_xi) + std::abs(step_eta) < 1e-9) return std::array{xi, eta};
  }
  return std::nullopt;
}

ZoneLocator::ZoneLocator(const Grid& grid) : grid_(grid) {
  const auto [x_low, x_high] = std::ranges::minmax(grid.x);
  const auto [y_low, y_high] = std::ranges::minmax(grid.y);
  x_min_ = x_low;
  y_min_ = y_low;
  const double zones = static_cast<double>(grid.zones.size());
  cell_ = std::max({std::sqrt((x_high - x_low) * (y_high - y_low) / zones), (x_high - x_low) / zones,
                    (y_high - y_low) / zones});
  columns_ = static_cast<std::size_t>((x_high - x_low) / cell_) + 1;
  rows_ = static_cast<std::size_t>((y_high - y_low) / cell_) + 1;

  const auto for_each_cell = [&](const ZonePoints& zone, auto&& visit) {
    const auto c = corners(grid, zone);
    const auto [x0, x1] = std::ranges::minmax(c.x);
    const auto [y0, y1] = std::ranges::minmax(c.y);
    const double margin_x = kTolerance * (x1 - x0), margin_y = kTolerance * (y1 - y0);
    const auto across = columns(x0 - margin_x, x1 + margin_x), up = rows(y0 - margin_y, y1 + margin_y);
    for (std::size_t j = up.first; j <= up.last; ++j)
      for (std::size_t i = across.first; i <= across.last; ++i) visit(j * columns_ + i);
  };
  starts_.assign(columns_ * rows_ + 1, 0);
  for (const auto& zone : grid.zones) for_each_cell(zone, [&](std::size_t cell) { ++starts_[cell + 1]; });
  for (std::size_t cell = 0; cell < columns_ * rows_; ++cell) starts_[cell + 1] += starts_[cell];
  zones_.resize(starts_.back());
  auto next = starts_;
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z)
    for_each_cell(grid.zones[z], [&](std::size_t cell) { zones_[next[cell]++] = z; });
}

ZoneLocator::Range ZoneLocator::columns(double low, double high) const {
  return {cell_of(low, x_min_, cell_, columns_), cell_of(high, x_min_, cell_, columns_)};
}

ZoneLocator::Range ZoneLocator::rows(double low, double high) const {
  return {cell_of(low, y_min_, cell_, rows_), cell_of(high, y_min_, cell_, rows_)};
}

std::optional<Place> ZoneLocator::locate(double x, double y) const {
  const std::size_t cell = cell_of(y, y_min_, cell_, rows_) * columns_ + cell_of(x, x_min_, cell_, columns_);
  for (std::uint32_t k = starts_[cell]; k < starts_[cell + 1]; ++k) {
    const auto natural = inverse_bilinear(corners(grid_, grid_.zones[zones_[k]]), x, y);
    if (!natural) continue;
    const auto [xi, eta] = *natural;
    if (std::abs(xi) > 1 + kTolerance || std::abs(eta) > 1 + kTolerance) continue;
    const double a = snap(xi), b = snap(eta);
    return Place{zones_[k],
                 {0.25 * (1 - a) * (1 - b), 0.25 * (1 + a) * (1 - b), 0.25 * (1 + a) * (1 + b),
                  0.25 * (1 - a) * (1 + b)}};
  }
  return std::nullopt;
}

}  // namespace adit::fdm
