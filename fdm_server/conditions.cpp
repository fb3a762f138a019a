#include "fdm_server/conditions.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/selection.hpp"
#include "protocol/time_function.hpp"

namespace adit::fdm {
namespace {

double tolerance(const Block& block) {
  return 1e-9 * std::hypot(block.x_max - block.x_min, block.y_max - block.y_min);
}

std::vector<double> interleaved(const Grid& grid) {
  std::vector<double> points;
  points.reserve(2 * grid.x.size());
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    points.push_back(grid.x[i]);
    points.push_back(grid.y[i]);
  }
  return points;
}

TimeFactor factor(const scene::TimeFunction& function, const std::string& path) {
  protocol::check(function, path + ".time");
  return [function](double t) { return protocol::evaluate(function, t); };
}

struct Edge {
  std::uint32_t from, to;
  double length;
};

// Edges whose two ends lie on the same side of the block.
std::vector<Edge> outline(const Block& block, const Grid& grid) {
  const double close = tolerance(block);
  std::vector<Edge> edges;
  for (const auto& zone : grid.zones)
    for (std::size_t c = 0; c < 4; ++c) {
      const auto a = static_cast<std::uint32_t>(zone[c]), b = static_cast<std::uint32_t>(zone[(c + 1) % 4]);
      const auto on = [close](double first, double second, double side) {
        return std::abs(first - side) <= close && std::abs(second - side) <= close;
      };
      if (on(grid.x[a], grid.x[b], block.x_min) || on(grid.x[a], grid.x[b], block.x_max) ||
          on(grid.y[a], grid.y[b], block.y_min) || on(grid.y[a], grid.y[b], block.y_max))
        edges.push_back({a, b, std::hypot(grid.x[b] - grid.x[a], grid.y[b] - grid.y[a])});
    }
  return edges;
}

void add(Load& load, std::uint32_t point, double fx, double fy) {
  load.points.push_back(point);
  load.fx.push_back(fx);
  load.fy.push_back(fy);
}

Load point_load(const scene::Load& scene, std::span<const double> points, double close,
                const std::string& path) {
  const auto chosen = protocol::select(scene.where(), points, close, path + ".where", "grid points");
  const double share = 1.0 / static_cast<double>(chosen.size());
  Load load{{}, {}, {}, factor(scene.time(), path)};
  for (const auto point : chosen) add(load, point, share * scene.force().x(), share * scene.force().y());
  return load;
}

Load edge_load(const scene::Load& scene, std::span<const Edge> edges, const Grid& grid, double close,
               const std::string& path) {
  std::vector<Edge> chosen;
  double length = 0;
  for (const auto& edge : edges)
    if (protocol::inside(scene.where(), grid.x[edge.from], grid.y[edge.from], close) &&
        protocol::inside(scene.where(), grid.x[edge.to], grid.y[edge.to], close)) {
      chosen.push_back(edge);
      length += edge.length;
    }
  if (chosen.empty())
    throw protocol::UserError(path + ".where",
                              "holds no whole edge of the block's boundary; widen the box so that both ends "
                              "of at least one zone's outer edge lie inside");
  Load load{{}, {}, {}, factor(scene.time(), path)};
  for (const auto& edge : chosen) {
    const double half = edge.length / length / 2;
    add(load, edge.from, half * scene.force().x(), half * scene.force().y());
    add(load, edge.to, half * scene.force().x(), half * scene.force().y());
  }
  return load;
}

Load body_load(const scene::BodyLoad& scene, std::span<const double> points, std::span<const double> masses,
               double close, const std::string& path) {
  const auto chosen = protocol::select(scene.where(), points, close, path + ".where", "grid points");
  Load load{{}, {}, {}, factor(scene.time(), path)};
  for (const auto point : chosen)
    add(load, point, masses[point] * scene.acceleration().x(), masses[point] * scene.acceleration().y());
  return load;
}

bool same_velocity(const scene::GridMotion& a, double va, const scene::GridMotion& b, double vb) {
  return va == vb && (va == 0 || a.time().SerializeAsString() == b.time().SerializeAsString());
}

}  // namespace

std::vector<Load> resolve_loads(const scene::Continuum& scene, const Block& block, const Grid& grid,
                                std::span<const double> masses) {
  const auto points = interleaved(grid);
  const auto edges = outline(block, grid);
  const double close = tolerance(block);
  std::vector<Load> loads;
  for (int i = 0; i < scene.point_loads_size(); ++i)
    loads.push_back(
        point_load(scene.point_loads(i), points, close, fmt::format("continuum.point_loads[{}]", i)));
  for (int i = 0; i < scene.edge_loads_size(); ++i)
    loads.push_back(
        edge_load(scene.edge_loads(i), edges, grid, close, fmt::format("continuum.edge_loads[{}]", i)));
  for (int i = 0; i < scene.body_loads_size(); ++i)
    loads.push_back(
        body_load(scene.body_loads(i), points, masses, close, fmt::format("continuum.body_loads[{}]", i)));
  return loads;
}

std::vector<Motion> resolve_motions(const scene::Continuum& scene, const Block& block, const Grid& grid) {
  const auto points = interleaved(grid);
  std::vector<Motion> motions;
  // the motion that prescribes each point's x and y, or -1
  std::array<std::vector<int>, 2> owner{std::vector<int>(grid.x.size(), -1),
                                        std::vector<int>(grid.x.size(), -1)};
  const auto velocity = [&](int i, Axis axis) {
    const auto& v = scene.motions(i).velocity();
    return axis == Axis::kX ? v.x() : v.y();
  };
  const auto prescribe = [&](int i, Axis axis, std::span<const std::uint32_t> chosen) {
    const auto& here = scene.motions(i);
    const auto path = fmt::format("continuum.motions[{}]", i);
    Motion motion{{}, axis, velocity(i, axis), factor(here.time(), path)};
    for (const auto point : chosen) {
      int& before = owner[axis == Axis::kX ? 0 : 1][point];
      if (before >= 0 &&
          !same_velocity(scene.motions(before), velocity(before, axis), here, velocity(i, axis)))
        throw protocol::UserError(
            path + ".velocity",
            fmt::format(
                "prescribes another {} velocity than motions[{}] at the grid point ({}, {}) m; let one "
                "of the two boxes leave it out",
                axis == Axis::kX ? "x" : "y", before, grid.x[point], grid.y[point]));
      if (before >= 0) continue;
      before = i;
      motion.points.push_back(point);
    }
    motions.push_back(std::move(motion));
  };
  for (int i = 0; i < scene.motions_size(); ++i) {
    const auto path = fmt::format("continuum.motions[{}]", i);
    const auto& motion = scene.motions(i);
    if (!motion.velocity().has_x() && !motion.velocity().has_y())
      throw protocol::UserError(path + ".velocity",
                                "names no component; give x, y or both (0 fixes a component)");
    const auto chosen =
        protocol::select(motion.where(), points, tolerance(block), path + ".where", "grid points");
    if (motion.velocity().has_x()) prescribe(i, Axis::kX, chosen);
    if (motion.velocity().has_y()) prescribe(i, Axis::kY, chosen);
  }
  return motions;
}

}  // namespace adit::fdm
