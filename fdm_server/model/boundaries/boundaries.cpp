#include "fdm_server/model/boundaries/boundaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "fdm_server/boundaries/dashpot_set.hpp"
#include "fdm_server/model/boundaries/base.hpp"
#include "fdm_server/model/grid/selection.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

using protocol::UserError;

bool along_axis(double normal) {
  return std::abs(normal) > 1 - 1e-9;
}

bool contains(const PrescribedMotion& motion, std::uint32_t point) {
  return std::ranges::binary_search(motion.points, point);
}

// A dashpot takes nothing up where the motion along it is prescribed. One end may be: there the edge meets
// another one, which is held. So may all points of the grid, for waves in one dimension.
void require_yielding(std::span<const PrescribedMotion> motions, const BoundaryEdge& edge, Axis axis,
                      const Grid& grid, const std::string& path) {
  for (const PrescribedMotion& motion : motions)
    if (motion.axis == axis && contains(motion, edge.from) && contains(motion, edge.to) &&
        motion.points.size() < grid.x.size())
      throw UserError(
          path,
          fmt::format("absorbs nothing along {} between ({:.6g}, {:.6g}) and ({:.6g}, {:.6g}) m, where one "
                      "of `motions` prescribes that velocity; let its place leave this side out, or leave "
                      "the motion away (after statics: `motions: []`)",
                      axis == Axis::kX ? "x" : "y", grid.x[edge.from], grid.y[edge.from], grid.x[edge.to],
                      grid.y[edge.to]));
}

void quieten(const scene::QuietBoundary& quiet, const std::string& path, EdgeSet& edges,
             const ImpedanceOf& impedance, std::span<const PrescribedMotion> motions, DashpotSet& dashpots) {
  if (!quiet.normal() && !quiet.shear())
    throw UserError(path, "has neither `normal` nor `shear` dashpots; leave one of them true");
  const auto chosen = select_edges(edges.grid(), quiet.where(), path + ".where");
  for (const std::size_t e : edges.numbers(chosen, path + ".where")) {
    edges.claim(e, path, path + ".where");
    dashpots.add_quiet(edges, e, impedance, quiet.normal(), quiet.shear());
    if (quiet.has_source_distance()) dashpots.add_springs(edges, e, impedance, quiet.source_distance());
    const bool along_x = along_axis(edges[e].normal_x), along_y = along_axis(edges[e].normal_y);
    if (along_x || along_y)
      require_yielding(motions, edges[e], along_x == quiet.normal() ? Axis::kX : Axis::kY, edges.grid(),
                       path);
    if (quiet.normal()) dashpots.hold(edges, e, !along_y, !along_x);  // oblique: both
  }
}

void require_apart(std::span<const PrescribedMotion> base, std::span<const PrescribedMotion> motions,
                   const Grid& grid) {
  for (const PrescribedMotion& of_base : base)
    for (const PrescribedMotion& other : motions) {
      if (of_base.axis != other.axis) continue;
      for (const auto point : of_base.points)
        if (contains(other, point))
          throw UserError("continuum.base",
                          fmt::format("prescribes the {} velocity of the grid point ({}, {}) m, as one of "
                                      "`motions` does; let its place leave the base out",
                                      of_base.axis == Axis::kX ? "x" : "y", grid.x[point], grid.y[point]));
    }
}

}  // namespace

std::vector<FreeFieldColumn> add_columns(const scene::Continuum& scene, std::span<const BoundaryEdge> outline,
                                         Grid& grid) {
  std::vector<FreeFieldColumn> columns;
  if (scene.free_field().left())
    columns.push_back(add_column(grid, outline, -1, "continuum.free_field.left"));
  if (scene.free_field().right())
    columns.push_back(add_column(grid, outline, 1, "continuum.free_field.right"));
  return columns;
}

Boundaries resolve_boundaries(const scene::Continuum& scene, const BaseAccelerations& accelerations,
                              const Grid& grid, std::span<const BoundaryEdge> outline,
                              std::span<const FreeFieldColumn> columns, const ImpedanceOf& impedance,
                              std::span<const PrescribedMotion> motions) {
  EdgeSet edges(grid, outline, columns);
  DashpotSet dashpots;
  for (const auto& column : columns) {
    for (const auto& edge : column.edges) {
      edges.claim(*edges.find(edge.from, edge.to), "continuum.free_field", "continuum.free_field");
      require_yielding(motions, edge, Axis::kX, grid, "continuum.free_field");
    }
    dashpots.add_free_field(column, impedance);
  }
  for (int i = 0; i < scene.quiet_size(); ++i)
    quieten(scene.quiet(i), fmt::format("continuum.quiet[{}]", i), edges, impedance, motions, dashpots);
  BaseActions actions;
  if (scene.has_base()) {
    actions = resolve_base(scene.base(), accelerations, edges, impedance, dashpots);
    if (scene.base().kind() == scene::Base::COMPLIANT)
      for (const std::size_t e : actions.edges)
        require_yielding(motions, edges[e], scene.base().direction() == scene::Base::X ? Axis::kX : Axis::kY,
                         grid, "continuum.base");
  }
  require_apart(actions.motions, motions, grid);
  return {dashpots.in_order(grid), std::move(actions.loads), std::move(actions.motions)};
}

double spring_stiffness(const scene::Continuum& scene, const Grid& grid, const Ground& ground) {
  const auto edges = outline(grid);
  const EdgeSet set(grid, edges, {});
  std::vector<double> stiffness(grid.zones.size(), 0.0);
  for (int i = 0; i < scene.quiet_size(); ++i) {
    const scene::QuietBoundary& quiet = scene.quiet(i);
    if (!quiet.has_source_distance()) continue;
    const std::string path = fmt::format("continuum.quiet[{}].where", i);
    for (const std::size_t e : set.numbers(select_edges(grid, quiet.where(), path), path)) {
      const std::uint32_t zone = edges[e].zone;
      stiffness[zone] += 2 * edges[e].length / area(corners(grid, zone)) * ground.plane_law(zone).shear /
                         quiet.source_distance();
    }
  }
  return stiffness.empty() ? 0 : std::ranges::max(stiffness);
}

std::vector<bool> find_bearing_points(const scene::Continuum& scene, const BaseAccelerations& accelerations,
                                      const Grid& grid) {
  const auto edges = outline(grid);
  Grid with_columns = grid;
  const auto columns = add_columns(scene, edges, with_columns);
  const auto unit = [](std::uint32_t) { return Impedance{1, 1}; };
  std::vector<bool> bears(grid.x.size(), false);
  for (const Dashpot& dashpot :
       resolve_boundaries(scene, accelerations, with_columns, edges, columns, unit, {}).dashpots)
    if (dashpot.point < bears.size()) bears[dashpot.point] = true;
  return bears;
}

}  // namespace adit::fdm
