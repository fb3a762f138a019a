#include "fdm_server/grid/locate.hpp"

#include <algorithm>
#include <cmath>

namespace adit::fdm {
namespace {

constexpr double kTolerance = 1e-9;  // in natural coordinates

// Snaps to the zone's edges, so that a point on an edge depends on that edge's points only.
double snap(double natural) {
  return std::abs(natural) > 1 - kTolerance ? std::copysign(1, natural) : natural;
}

std::array<double, 4> bilinear(double xi, double eta) {
  return {0.25 * (1 - xi) * (1 - eta), 0.25 * (1 + xi) * (1 - eta), 0.25 * (1 + xi) * (1 + eta),
          0.25 * (1 - xi) * (1 + eta)};
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
    // Far outside it may vanish; the steps are then not finite, and the iteration ends without a result.
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
  std::vector<protocol::Extent> extents;
  extents.reserve(grid.zones.size());
  for (std::size_t zone = 0; zone < grid.zones.size(); ++zone) {
    const auto c = corners(grid, zone);
    const auto [x0, x1] = std::ranges::minmax(c.x);
    const auto [y0, y1] = std::ranges::minmax(c.y);
    const double margin_x = kTolerance * (x1 - x0), margin_y = kTolerance * (y1 - y0);
    extents.push_back({x0 - margin_x, x1 + margin_x, y0 - margin_y, y1 + margin_y});
  }
  const auto [x_low, x_high] = std::ranges::minmax(grid.x);
  const auto [y_low, y_high] = std::ranges::minmax(grid.y);
  const double width = x_high - x_low, height = y_high - y_low;
  const auto zones = static_cast<double>(grid.zones.size());
  // Cells of the mean area of a zone; in a slender grid no smaller than its length over the zones, so that
  // there are never many more cells than zones.
  cells_ = {extents, std::max({std::sqrt(width * height / zones), width / zones, height / zones})};
}

std::optional<Place> ZoneLocator::locate(double x, double y, const std::vector<bool>& hidden) const {
  for (const std::uint32_t zone : cells_.at(x, y)) {
    if (!hidden.empty() && hidden[zone]) continue;
    const auto natural = inverse_bilinear(corners(grid_, zone), x, y);
    if (!natural) continue;
    const auto [xi, eta] = *natural;
    if (std::abs(xi) > 1 + kTolerance || std::abs(eta) > 1 + kTolerance) continue;
    const double a = snap(xi), b = snap(eta);
    return Place{zone, bilinear(a, b)};
  }
  return std::nullopt;
}

std::optional<Place> ZoneLocator::beyond(double x, double y) const {
  double least = 3;  // a zone's width from its side
  std::optional<Place> nearest;
  for (std::uint32_t zone = 0; zone < grid_.zones.size(); ++zone) {
    const auto natural = inverse_bilinear(corners(grid_, zone), x, y);
    if (!natural) continue;
    const auto [xi, eta] = *natural;
    const double away = std::max(std::abs(xi), std::abs(eta));
    if (away >= least) continue;
    least = away;
    nearest = Place{zone, bilinear(xi, eta)};
  }
  return nearest;
}

}  // namespace adit::fdm
