#include "dem_server/coupling/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adit::dem {
namespace {

constexpr double kTolerance = 1e-9;  // of the shares

// Drops what is rounding; the largest share takes up the rest.
void snap(std::array<double, 3>& shares) {
  for (double& share : shares)
    if (std::abs(share) < kTolerance) share = 0;
  const auto largest = static_cast<std::size_t>(std::ranges::max_element(shares) - shares.begin());
  shares[largest] = 1 - (shares[(largest + 1) % 3] + shares[(largest + 2) % 3]);
}

}  // namespace

Triangulation::Triangulation(const Particles& particles, const BondEnds& bonds)
    : particles_(particles), reach_((1 + kTolerance) * bonds.longest) {
  find_triangles(bonds);
  std::vector<protocol::Extent> extents;
  extents.reserve(triangles_.size());
  const double margin = kTolerance * bonds.longest;
  for (const auto& [a, b, c] : triangles_) {
    const auto [x0, x1] = std::minmax({particles.x[a], particles.x[b], particles.x[c]});
    const auto [y0, y1] = std::minmax({particles.y[a], particles.y[b], particles.y[c]});
    extents.push_back({x0 - margin, x1 + margin, y0 - margin, y1 + margin});
  }
  cells_ = {extents, bonds.longest};
}

// A triangle is found once, at the particle of the lowest number: two of its bonds lead to higher ones, which
// are bonded.
void Triangulation::find_triangles(const BondEnds& bonds) {
  const BondedNeighbours neighbours(bonds, particles_.size());
  for (std::uint32_t i = 0; i < particles_.size(); ++i) {
    const auto above = neighbours.above(i);
    for (std::size_t a = 0; a < above.size(); ++a)
      for (std::size_t b = a + 1; b < above.size(); ++b)
        if (neighbours.bonded(above[a], above[b])) triangles_.push_back({i, above[a], above[b]});
  }
}

// Barycentric coordinates, relative to a corner, so that far from the origin no digit is lost.
std::array<double, 3> Triangulation::shares(const Triangle& t, double x, double y) const {
  const auto& px = particles_.x;
  const auto& py = particles_.y;
  const double ax = px[t[1]] - px[t[0]], ay = py[t[1]] - py[t[0]];
  const double bx = px[t[2]] - px[t[0]], by = py[t[2]] - py[t[0]];
  const double dx = x - px[t[0]], dy = y - py[t[0]], twice_area = ax * by - ay * bx;
  const double second = (dx * by - dy * bx) / twice_area, third = (ax * dy - ay * dx) / twice_area;
  return {1 - second - third, second, third};
}

// From a place outside the triangle to its nearest side [m].
double Triangulation::distance(const Triangle& t, double x, double y) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t side = 0; side < 3; ++side) {
    const std::uint32_t from = t[side], to = t[(side + 1) % 3];
    const double ax = particles_.x[to] - particles_.x[from], ay = particles_.y[to] - particles_.y[from];
    const double dx = x - particles_.x[from], dy = y - particles_.y[from];
    const double along = std::clamp((dx * ax + dy * ay) / (ax * ax + ay * ay), 0.0, 1.0);
    least = std::min(least, std::hypot(dx - along * ax, dy - along * ay));
  }
  return least;
}

std::optional<TrianglePlace> Triangulation::locate(double x, double y) const {
  const Triangle* triangle = holding(x, y);
  if (triangle == nullptr) triangle = nearest(x, y);
  if (triangle == nullptr) return std::nullopt;
  TrianglePlace place{*triangle, shares(*triangle, x, y)};
  snap(place.shares);
  return place;
}

const Triangulation::Triangle* Triangulation::holding(double x, double y) const {
  for (const std::uint32_t t : cells_.at(x, y))
    if (std::ranges::min(shares(triangles_[t], x, y)) >= -kTolerance) return &triangles_[t];
  return nullptr;
}

const Triangulation::Triangle* Triangulation::nearest(double x, double y) const {
  const Triangle* best = nullptr;
  double least = reach_;
  cells_.visit_near(x, y, reach_, [&](std::uint32_t t) {
    if (const double apart = distance(triangles_[t], x, y); apart < least) {
      least = apart;
      best = &triangles_[t];
    }
  });
  return best;
}

}  // namespace adit::dem
