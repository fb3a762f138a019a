#include "fdm_server/boundaries/free_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

// The lower end of an edge of the side.
std::uint32_t lower(const Grid& grid, const BoundaryEdge& edge) {
  return grid.y[edge.from] < grid.y[edge.to] ? edge.from : edge.to;
}
std::uint32_t upper(const Grid& grid, const BoundaryEdge& edge) {
  return grid.y[edge.from] < grid.y[edge.to] ? edge.to : edge.from;
}

std::vector<BoundaryEdge> side_edges(const Grid& grid, std::span<const BoundaryEdge> outline, double normal_x,
                                     const std::string& path) {
  constexpr double kStraight = 1e-9;  // of the grid's width
  double outermost = -HUGE_VAL, innermost = HUGE_VAL;
  for (const auto& edge : outline) {
    outermost = std::max(outermost, normal_x * grid.x[edge.from]);
    innermost = std::min(innermost, normal_x * grid.x[edge.from]);
  }
  const double on_side = outermost - kStraight * (outermost - innermost);
  std::vector<BoundaryEdge> edges;
  std::ranges::copy_if(outline, std::back_inserter(edges), [&](const BoundaryEdge& edge) {
    return normal_x * grid.x[edge.from] >= on_side && normal_x * grid.x[edge.to] >= on_side;
  });
  // Both sides are sorted from below, although the outline passes them in opposite directions.
  std::ranges::sort(edges, {}, [&](const BoundaryEdge& edge) { return grid.y[lower(grid, edge)]; });
  const char* side = normal_x < 0 ? "left" : "right";
  if (edges.empty())
    throw protocol::UserError(path, fmt::format("finds no vertical edge at the continuum's {} side", side));
  for (std::size_t k = 1; k < edges.size(); ++k)
    if (lower(grid, edges[k]) != upper(grid, edges[k - 1]))
      throw protocol::UserError(
          path, fmt::format("needs a {} side that is one vertical line, but it is interrupted at ({}, {}) m; "
                            "let the grid end in one line there, or leave the free field out",
                            side, grid.x[upper(grid, edges[k - 1])], grid.y[upper(grid, edges[k - 1])]));
  return edges;
}

double width_of(const Corners& corners) {
  const auto [left, right] = std::ranges::minmax(corners.x);
  return right - left;
}

}  // namespace

FreeFieldColumn add_column(Grid& grid, std::span<const BoundaryEdge> outline, double normal_x,
                           const std::string& path) {
  FreeFieldColumn column{.normal_x = normal_x,
                         .width = 0,
                         .edges = side_edges(grid, outline, normal_x, path),
                         .side = {},
                         .first_point = static_cast<std::uint32_t>(grid.x.size()),
                         .first_zone = static_cast<std::uint32_t>(grid.zones.size())};
  for (const auto& edge : column.edges)
    column.width = std::max(column.width, width_of(corners(grid, edge.zone)));
  column.side.push_back(lower(grid, column.edges.front()));
  for (const auto& edge : column.edges) column.side.push_back(upper(grid, edge));

  const double at_side = grid.x[column.side.front()], beyond = at_side + normal_x * column.width;
  const auto [left, right] = std::minmax(at_side, beyond);
  for (const auto point : column.side) {
    grid.x.push_back(beyond);
    grid.y.push_back(grid.y[point]);
  }
  for (std::size_t k = 0; k < column.edges.size(); ++k) {
    const auto a = static_cast<std::int32_t>(column.point(k)), b = a + 1;
    const double bottom = grid.y[column.side[k]], top = grid.y[column.side[k + 1]];
    grid.zones.push_back({a, a, b, b});
    grid.own_corners.push_back({{left, right, right, left}, {bottom, bottom, top, top}});
  }
  grid.column_points += static_cast<std::uint32_t>(column.side.size());
  return column;
}

void extend_to_column(const FreeFieldColumn& column, std::span<const double> masses, Load& body_load) {
  // A copy: the search needs ascending numbers, which the points appended below would break.
  const std::vector<std::uint32_t> given = body_load.points;
  for (std::size_t k = 0; k < column.side.size(); ++k) {
    const auto found = std::ranges::lower_bound(given, column.side[k]);
    if (found == given.end() || *found != column.side[k]) continue;
    const auto i = static_cast<std::size_t>(found - given.begin());
    // Such a load is an acceleration times the mass, so the column's share is that of its mass.
    const double ratio = masses[column.point(k)] / masses[column.side[k]];
    body_load.points.push_back(column.point(k));
    body_load.fx.push_back(ratio * body_load.fx[i]);
    body_load.fy.push_back(ratio * body_load.fy[i]);
  }
}

void extend_to_column(const FreeFieldColumn& column, std::vector<std::uint32_t>& points) {
  const std::vector<std::uint32_t> given = points;
  for (std::size_t k = 0; k < column.side.size(); ++k)
    if (std::ranges::binary_search(given, column.side[k])) points.push_back(column.point(k));
}

}  // namespace adit::fdm
