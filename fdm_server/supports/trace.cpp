#include "fdm_server/supports/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

constexpr double kNear = 0.05;  // of an edge's length

struct Step {
  std::uint32_t to;
  double s, distance, length;
};

double distance(const Grid& grid, std::size_t point, const geometry::Point& place) {
  return std::hypot(grid.x[point] - place.x, grid.y[point] - place.y);
}

[[noreturn]] void refuse(const Grid& grid, const geometry::Point& place, const std::string& path) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    if (distance(grid, i, place) < distance(grid, nearest, place)) nearest = i;
  const std::string begin =
      fmt::format("has no sides of zones along it at ({:.6g}, {:.6g}) m", place.x, place.y);
  const std::string remedy =
      "let the grid have a line of points along it (a ring of zones, a curve of the mesh), or put it on grid "
      "points";
  constexpr double kSamePlace = 1e-6;  // [m]
  throw protocol::UserError(
      path,
      distance(grid, nearest, place) < kSamePlace
          ? fmt::format("{}, where a grid point lies, but no zone has a side that goes on along it: zones "
                        "end there, by the grid or by an overlap, or lie across it; {}",
                        begin, remedy)
          : fmt::format("{}, where the nearest grid point is ({:.6g}, {:.6g}) m; {}", begin, grid.x[nearest],
                        grid.y[nearest], remedy));
}

// The steps from each point along the curve, the nearest to it first.
std::map<std::uint32_t, std::vector<Step>> steps_along(const Grid& grid, const Edges& edges,
                                                       const Curve& curve) {
  std::map<std::uint32_t, std::vector<Step>> steps;
  for (const auto& edge : edges.list) {
    const double length =
        std::hypot(grid.x[edge.to] - grid.x[edge.from], grid.y[edge.to] - grid.y[edge.from]);
    auto from = curve.foot({grid.x[edge.from], grid.y[edge.from]});
    auto to = curve.foot({grid.x[edge.to], grid.y[edge.to]});
    if (std::max(from.distance, to.distance) > kNear * length) continue;
    double along = to.s - from.s;
    // The edge over the start of a closed curve goes on by its own length, not back by the whole curve.
    if (curve.closed()) along = std::remainder(along, curve.length());
    if (std::abs(along) < length / 2) continue;
    const auto add = [&](std::int32_t a, std::int32_t b, const Curve::Foot& foot) {
      steps[static_cast<std::uint32_t>(a)].push_back(
          {static_cast<std::uint32_t>(b), foot.s, foot.distance, length});
    };
    along > 0 ? add(edge.from, edge.to, to) : add(edge.to, edge.from, from);
  }
  for (auto& [point, ways] : steps) std::ranges::sort(ways, {}, &Step::distance);
  return steps;
}

}  // namespace

Path trace(const Grid& grid, const Edges& edges, const Curve& curve, const std::string& path) {
  const auto steps = steps_along(grid, edges, curve);
  const auto start = curve.at(0), end = curve.at(curve.length());
  const auto first = std::ranges::min_element(
      steps, {}, [&](const auto& step) { return distance(grid, step.first, start); });
  if (first == steps.end() || distance(grid, first->first, start) > first->second.front().length / 2)
    refuse(grid, start, path);

  Path found{{first->first}, curve.closed()};
  while (true) {
    const auto here = found.points.back();
    const auto onward = steps.find(here);
    if (onward == steps.end()) refuse(grid, {grid.x[here], grid.y[here]}, path);
    const Step& step = onward->second.front();
    if (curve.closed() && step.to == found.points.front()) return found;
    found.points.push_back(step.to);
    if (!curve.closed() && distance(grid, step.to, end) <= step.length / 2) return found;
    // A way that passes more points than there are runs in circles and never reaches the end.
    if (found.points.size() > grid.x.size()) refuse(grid, {grid.x[here], grid.y[here]}, path);
  }
}

Path chain(const Grid& grid, std::span<const Edge> edges, const std::string& path) {
  std::map<std::int32_t, std::vector<std::int32_t>> neighbours;
  for (const auto& [from, to, zone] : edges) {
    neighbours[from].push_back(to);
    neighbours[to].push_back(from);
  }
  std::vector<std::int32_t> ends;
  for (const auto& [point, others] : neighbours) {
    if (others.size() == 1) ends.push_back(point);
    if (others.size() > 2)
      throw protocol::UserError(
          path, fmt::format("holds edges that branch at ({:.6g}, {:.6g}) m; narrow it so that "
                            "they form one line",
                            grid.x[point], grid.y[point]));
  }
  Path found{{}, ends.empty()};
  std::int32_t before = -1, here = ends.empty() ? edges[0].from : ends[0];
  while (found.points.empty() || here != static_cast<std::int32_t>(found.points.front())) {
    found.points.push_back(static_cast<std::uint32_t>(here));
    const auto& ways = neighbours.at(here);
    const auto next = std::ranges::find_if(ways, [&](auto way) { return way != before; });
    if (next == ways.end()) break;
    before = here;
    here = *next;
  }
  if (found.points.size() < neighbours.size())
    throw protocol::UserError(
        path, fmt::format("holds several separate lines of edges, one of them at ({:.6g}, {:.6g}) "
                          "m; narrow it so that it holds one",
                          grid.x[found.points[0]], grid.y[found.points[0]]));
  const auto at = std::ranges::find(found.points, static_cast<std::uint32_t>(edges[0].from));
  const auto next = at + 1 == found.points.end() ? found.points.begin() : at + 1;
  // An edge has its zone on its left, so the path runs against the first edge to have it on the right.
  if (*next == static_cast<std::uint32_t>(edges[0].to)) std::ranges::reverse(found.points);
  return found;
}

}  // namespace adit::fdm
