#include "fdm_server/model/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fdm_server/model/grid/selection.hpp"
#include "protocol/participant/time_function.hpp"

namespace adit::fdm {
namespace {

TimeFactor factor(const scene::TimeFunction& function) {
  return [function](double t) { return protocol::evaluate(function, t); };
}

void add(Load& load, std::uint32_t point, double fx, double fy) {
  load.points.push_back(point);
  load.fx.push_back(fx);
  load.fy.push_back(fy);
}

// Forces that never change take up the factor, and have none.
Load over_time(Load load, const scene::TimeFunction& time) {
  load.factor = factor(time);
  if (!protocol::is_steady(time)) return load;
  for (auto* forces : {&load.fx, &load.fy})
    for (double& force : *forces) force *= load.factor(0);
  load.factor = nullptr;
  return load;
}

Load point_load(const scene::Load& scene, const Grid& grid, const std::string& path) {
  const auto chosen = select_points(grid, scene.where(), path + ".where");
  const double share = 1.0 / static_cast<double>(chosen.size());
  Load load;
  for (const auto point : chosen) add(load, point, share * scene.force().x(), share * scene.force().y());
  return over_time(std::move(load), scene.time());
}

double length(const Edge& edge, const Grid& grid) {
  return std::hypot(grid.x[edge.to] - grid.x[edge.from], grid.y[edge.to] - grid.y[edge.from]);
}

// Where the edge meets the column's side, at an end of it, the column's own surface goes on from there.
std::optional<std::uint32_t> surface_of(const FreeFieldColumn& column, const Edge& edge) {
  const auto on_side = [&column](std::uint32_t point) {
    return std::ranges::find(column.side, point) != column.side.end();
  };
  if (on_side(edge.from) == on_side(edge.to)) return std::nullopt;
  const std::uint32_t meeting = on_side(edge.from) ? edge.from : edge.to;
  if (meeting == column.side.back()) return column.top();
  if (meeting == column.side.front()) return column.point(0);
  return std::nullopt;
}

Load edge_load(const scene::Load& scene, const Grid& grid, std::span<const FreeFieldColumn> columns,
               const std::string& path) {
  const auto chosen = select_edges(grid, scene.where(), path + ".where");
  double whole = 0;
  for (const auto& edge : chosen) whole += length(edge, grid);
  Load load;
  for (const auto& edge : chosen) {
    const double half = length(edge, grid) / whole / 2;
    add(load, edge.from, half * scene.force().x(), half * scene.force().y());
    add(load, edge.to, half * scene.force().x(), half * scene.force().y());
    for (const FreeFieldColumn& column : columns)
      if (const auto point = surface_of(column, edge)) {
        const double share = column.width / whole;
        add(load, *point, share * scene.force().x(), share * scene.force().y());
      }
  }
  return over_time(std::move(load), scene.time());
}

Load body_load(const scene::BodyLoad& scene, const Grid& grid, std::span<const double> masses,
               std::span<const FreeFieldColumn> columns, const std::string& path) {
  const auto chosen = select_points(grid, scene.where(), path + ".where");
  Load load;
  for (const auto point : chosen)
    add(load, point, masses[point] * scene.acceleration().x(), masses[point] * scene.acceleration().y());
  for (const FreeFieldColumn& column : columns) extend_to_column(column, masses, load);
  return over_time(std::move(load), scene.time());
}

}  // namespace

std::vector<Load> resolve_loads(const scene::Continuum& scene, const Grid& grid,
                                std::span<const double> masses, std::span<const FreeFieldColumn> columns) {
  std::vector<Load> loads;
  for (int i = 0; i < scene.point_loads_size(); ++i)
    loads.push_back(point_load(scene.point_loads(i), grid, fmt::format("continuum.point_loads[{}]", i)));
  for (int i = 0; i < scene.edge_loads_size(); ++i)
    loads.push_back(
        edge_load(scene.edge_loads(i), grid, columns, fmt::format("continuum.edge_loads[{}]", i)));
  for (int i = 0; i < scene.body_loads_size(); ++i)
    loads.push_back(
        body_load(scene.body_loads(i), grid, masses, columns, fmt::format("continuum.body_loads[{}]", i)));
  return loads;
}

}  // namespace adit::fdm
