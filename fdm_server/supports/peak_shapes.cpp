#include "fdm_server/supports/peak_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adit::fdm {
namespace {

constexpr double kRound = 0.01;  // distances from the middle may differ by so much, relative to their mean
constexpr double kLevel = 1e-6;  // heights that count as equal, relative to the lining's

double mean(std::span<const double> values, std::span<const std::uint32_t> points) {
  double sum = 0;
  for (const auto point : points) sum += values[point];
  return sum / static_cast<double>(points.size());
}

}  // namespace

PeakShapes::PeakShapes(const Grid& grid, std::span<const Lining> linings) {
  for (const Lining& lining : linings)
    outlines_.push_back(lining.path.closed ? std::optional(outline(grid, lining.path)) : std::nullopt);
}

PeakShapes::Outline PeakShapes::outline(const Grid& grid, const Path& path) {
  Outline out{};
  double length = 0, middle_x = 0, middle_y = 0;
  std::vector<double> shares(path.points.size());
  for (std::size_t k = 0; k < path.sides(); ++k) {
    const auto [from, to] = path.side(k);
    const double side = std::hypot(grid.x[to] - grid.x[from], grid.y[to] - grid.y[from]);
    length += side;
    middle_x += side * (grid.x[from] + grid.x[to]) / 2;
    middle_y += side * (grid.y[from] + grid.y[to]) / 2;
    shares[k] += side / 2;
    shares[(k + 1) % shares.size()] += side / 2;
  }
  middle_x /= length;
  middle_y /= length;
  double low = std::numeric_limits<double>::infinity(), high = -low, near = low, far = 0;
  for (std::size_t k = 0; k < path.points.size(); ++k) {
    const auto point = path.points[k];
    const double x = grid.x[point] - middle_x, y = grid.y[point] - middle_y, radius = std::hypot(x, y);
    near = std::min(near, radius);
    far = std::max(far, radius);
    low = std::min(low, grid.y[point]);
    high = std::max(high, grid.y[point]);
    out.nodes.push_back({point, x / radius, y / radius, shares[k] / length});
  }
  out.round = far - near <= kRound * (far + near) / 2;
  for (const auto point : path.points) {
    if (grid.y[point] >= high - kLevel * (high - low)) out.top.push_back(point);
    if (grid.y[point] <= low + kLevel * (high - low)) out.bottom.push_back(point);
  }
  return out;
}

PeakShapes::Peak PeakShapes::Outline::now(std::span<const double> ux, std::span<const double> uy,
                                          double time) const {
  if (!round) return {mean(ux, top) - mean(ux, bottom), 0, time};
  double a = 0, b = 0;
  for (const auto& [point, x, y, share] : nodes) {
    const double radial = ux[point] * x + uy[point] * y;
    a += 2 * share * radial * (x * x - y * y);
    b += 2 * share * radial * 2 * x * y;
  }
  return {2 * std::hypot(a, b), std::atan2(b, a) / 2, time};
}

void PeakShapes::take(std::span<const double> ux, std::span<const double> uy, double time) {
  const bool first = peaks_.empty();
  if (first) peaks_.resize(outlines_.size());
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    if (!outlines_[i]) continue;
    const Peak now = outlines_[i]->now(ux, uy, time);
    if (first || std::abs(now.size) > std::abs(peaks_[i].size)) peaks_[i] = now;
  }
}

std::optional<PeakShapes::Peak> PeakShapes::of(std::size_t lining) const {
  if (peaks_.empty() || !outlines_[lining]) return std::nullopt;
  return peaks_[lining];
}

void PeakShapes::exchange(state::Archive& archive) {
  archive.all_or_none("lining_shapes", {&peaks_}, outlines_.size());
}

}  // namespace adit::fdm
