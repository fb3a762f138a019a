#include "fdm_server/boundaries/edge_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/selection.hpp"

namespace adit::fdm {
namespace {

double tolerance(const Grid& grid) {
  const auto [left, right] = std::ranges::minmax(grid.x);
  const auto [low, high] = std::ranges::minmax(grid.y);
  return 1e-9 * std::hypot(right - left, high - low);
}

}  // namespace

// c_p = sqrt((kappa + mu)/rho) in either plane condition, c_s = sqrt(mu/rho)
Impedance impedance(const PlaneLaw& law, double density, double weight) {
  return {weight * std::sqrt(density * (law.bulk + law.shear)), weight * std::sqrt(density * law.shear)};
}

Symmetric dashpots(const BoundaryEdge& edge, const Impedance& impedance) {
  const double n = impedance.normal, t = impedance.shear, x = edge.normal_x, y = edge.normal_y;
  return {n * x * x + t * y * y, (n - t) * x * y, n * y * y + t * x * x};
}

std::vector<std::size_t> EdgeSet::inside(const scene::Box& box, const std::string& path) const {
  const double close = tolerance(grid_);
  const auto holds = [&](std::uint32_t i) { return protocol::inside(box, grid_.x[i], grid_.y[i], close); };
  std::vector<std::size_t> chosen;
  for (std::size_t e = 0; e < outline_.size(); ++e)
    if (holds(outline_[e].from) && holds(outline_[e].to)) chosen.push_back(e);
  if (chosen.empty())
    throw protocol::UserError(
        path,
        "holds no whole edge of the continuum's boundary; widen it so that both ends of "
        "at least one zone's outer edge lie inside");
  return chosen;
}

std::vector<std::size_t> EdgeSet::lowest() const {
  double bottom = HUGE_VAL;
  for (const auto& edge : outline_) bottom = std::min(bottom, grid_.y[edge.from]);
  scene::Box box;
  box.set_y_max(bottom);
  return inside(box, "continuum.base");
}

void EdgeSet::claim(std::size_t e, const std::string& holder, const std::string& path) {
  const BoundaryEdge& edge = outline_[e];
  if (!holders_[e].empty())
    throw protocol::UserError(
        path,
        fmt::format("holds the boundary edge from ({}, {}) to ({}, {}) m, as {} does; an edge has one "
                    "condition, shrink one of the two",
                    grid_.x[edge.from], grid_.y[edge.from], grid_.x[edge.to], grid_.y[edge.to], holders_[e]));
  holders_[e] = holder;
}

void EdgeSet::claim(const BoundaryEdge& edge, const std::string& holder) {
  const auto found = std::ranges::find_if(
      outline_, [&](const BoundaryEdge& other) { return other.from == edge.from && other.to == edge.to; });
  claim(static_cast<std::size_t>(found - outline_.begin()), holder, holder);
}

std::vector<EdgeShare> EdgeSet::shares(std::size_t e) const {
  const BoundaryEdge& edge = outline_[e];
  std::vector<EdgeShare> shares;
  for (const auto point : {edge.from, edge.to})
    shares.push_back({point, edge.zone, edge.length / 2, grid_.x[point]});
  for (const auto& column : columns_) {
    const std::size_t last = column.edges.size();
    for (const auto& [point, zone] : {std::pair{std::size_t{0}, std::size_t{0}}, std::pair{last, last - 1}})
      if (column.side[point] == edge.from || column.side[point] == edge.to)
        shares.push_back({column.point(point), column.zone(zone), column.width, grid_.x[column.side[point]]});
  }
  return shares;
}

}  // namespace adit::fdm
