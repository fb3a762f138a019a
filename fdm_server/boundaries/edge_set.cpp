#include "fdm_server/boundaries/edge_set.hpp"

#include <fmt/format.h>

#include <cmath>

#include "protocol/errors.hpp"

namespace adit::fdm {

// c_p = sqrt((kappa + mu)/rho) in either plane condition, c_s = sqrt(mu/rho)
Impedance impedance(const PlaneLaw& law, double density, double weight) {
  return {weight * std::sqrt(density * (law.bulk + law.shear)), weight * std::sqrt(density * law.shear),
          weight * law.shear};
}

namespace {

// a n n' + b t t'
Symmetric across_and_along(const BoundaryEdge& edge, double a, double b) {
  const double x = edge.normal_x, y = edge.normal_y;
  return {a * x * x + b * y * y, (a - b) * x * y, a * y * y + b * x * x};
}

}  // namespace

Symmetric dashpots(const BoundaryEdge& edge, const Impedance& impedance) {
  return across_and_along(edge, impedance.normal, impedance.shear);
}

Symmetric springs(const BoundaryEdge& edge, double shear_modulus, double source_distance) {
  const double across = shear_modulus / source_distance;
  return across_and_along(edge, across, across / 2);
}

EdgeSet::EdgeSet(const Grid& grid, std::span<const BoundaryEdge> outline,
                 std::span<const FreeFieldColumn> columns)
    : grid_(grid), outline_(outline), columns_(columns), holders_(outline.size()) {
  for (std::size_t e = 0; e < outline.size(); ++e) number_of_[{outline[e].from, outline[e].to}] = e;
}

std::optional<std::size_t> EdgeSet::find(std::uint32_t from, std::uint32_t to) const {
  const auto found = number_of_.find({from, to});
  return found == number_of_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::size_t> EdgeSet::numbers(std::span<const Edge> edges, const std::string& path) const {
  std::vector<std::size_t> chosen;
  for (const Edge& edge : edges) {
    const auto from = static_cast<std::uint32_t>(edge.from), to = static_cast<std::uint32_t>(edge.to);
    auto number = find(from, to);
    if (!number) number = find(to, from);
    if (!number)
      throw protocol::UserError(
          path, fmt::format("holds the edge from ({}, {}) to ({}, {}) m, which is none of the "
                            "continuum's boundary; choose edges at its outside",
                            grid_.x[from], grid_.y[from], grid_.x[to], grid_.y[to]));
    chosen.push_back(*number);
  }
  return chosen;
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
