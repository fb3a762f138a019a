#include "fdm_server/grid/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fdm_server/grid/edges.hpp"
#include "fdm_server/grid/locate.hpp"
#include "protocol/errors.hpp"
#include "protocol/geometry/cells.hpp"

namespace adit::fdm {
namespace {

using protocol::UserError;

constexpr double kFlat = 1e-9;   // Jacobian over the largest diagonal squared
constexpr double kReach = 1e-3;  // of a zone: points that near to it count as in it

double cross(const Corners& c, std::size_t at, std::size_t a, std::size_t b) {
  return (c.x[a] - c.x[at]) * (c.y[b] - c.y[at]) - (c.x[b] - c.x[at]) * (c.y[a] - c.y[at]);
}

void require_convex(const Grid& grid, const std::string& path, const ZoneName& name_of) {
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z) {
    const auto c = corners(grid, z);
    const double diagonal =
        std::max(std::hypot(c.x[2] - c.x[0], c.y[2] - c.y[0]), std::hypot(c.x[3] - c.x[1], c.y[3] - c.y[1]));
    for (std::size_t i = 0; i < 4; ++i)
      if (!(cross(c, i, (i + 1) % 4, (i + 3) % 4) > kFlat * diagonal * diagonal))
        throw UserError(
            path, fmt::format("has a tangled zone: {} is not convex at its corner ({:.9g}, {:.9g}) m; let "
                              "every zone have four corners, in order, with angles below 180 degrees",
                              name_of(z), c.x[i], c.y[i]));
  }
}

[[noreturn]] void refuse_meeting(const Grid& grid, const std::string& path, const ZoneName& name_of,
                                 const Edge& side, std::uint32_t zone, const std::array<double, 2>& natural) {
  const auto near_one = [](double value) { return std::abs(std::abs(value) - 1) <= kReach; };
  const double x = grid.x[side.from], y = grid.y[side.from];
  const std::string own = name_of(side.zone), other = name_of(zone);
  if (near_one(natural[0]) && near_one(natural[1]))
    throw UserError(
        path, fmt::format("is not joined at ({:.9g}, {:.9g}) m: {} and {} each have a point of their own "
                          "there; make them one point",
                          x, y, own, other));
  if (near_one(natural[0]) || near_one(natural[1]))
    throw UserError(
        path, fmt::format("is not joined at ({:.9g}, {:.9g}) m: a point of {} lies on a side of {}; let "
                          "both have the same points along the line they share",
                          x, y, own, other));
  throw UserError(
      path, fmt::format("overlaps itself at ({:.9g}, {:.9g}) m: a point of {} lies inside {}; move them "
                        "apart, or let both have the same points along the line they share",
                        x, y, own, other));
}

// Zones go counter-clockwise, so the two beside an edge run along it in opposite directions.
void require_beside_each_other(const Grid& grid, const Edges& edges, const std::string& path,
                               const ZoneName& name_of) {
  constexpr std::uint32_t kNone = UINT32_MAX;
  std::vector<std::array<std::uint32_t, 2>> beside(edges.list.size(), {kNone, kNone});
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z)
    for (std::size_t c = 0; c < 4; ++c) {
      const std::uint32_t number = edges.of_zone[z][c];
      const Edge& edge = edges.list[number];
      std::uint32_t& other = beside[number][grid.zones[z][c] == edge.from ? 0 : 1];
      if (other != kNone)
        throw UserError(
            path,
            fmt::format("overlaps itself: {} and {} lie on the same side of their common edge from "
                        "({:.9g}, {:.9g}) m to ({:.9g}, {:.9g}) m; move them apart, or keep one of them",
                        name_of(other), name_of(z), grid.x[edge.from], grid.y[edge.from], grid.x[edge.to],
                        grid.y[edge.to]));
      other = z;
    }
}

// Every point of the boundary begins one of its edges.
void require_joined(const Grid& grid, const std::string& path, const ZoneName& name_of) {
  std::vector<protocol::Extent> extents;
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z) {
    const auto c = corners(grid, z);
    const auto [x0, x1] = std::ranges::minmax(c.x);
    const auto [y0, y1] = std::ranges::minmax(c.y);
    // Boxes are widened by the tolerance, else a point just outside a zone would not be looked at.
    const double margin = kReach * std::max(x1 - x0, y1 - y0);
    extents.push_back({x0 - margin, x1 + margin, y0 - margin, y1 + margin});
  }
  const auto box = bounds(grid);
  const double width = box.x_max - box.x_min, height = box.y_max - box.y_min;
  const auto zones = static_cast<double>(grid.zones.size());
  const protocol::Cells cells(extents,
                              std::max({std::sqrt(width * height / zones), width / zones, height / zones}));
  for (const Edge& side : grid.boundary)
    for (const std::uint32_t zone : cells.at(grid.x[side.from], grid.y[side.from])) {
      const double x = grid.x[side.from], y = grid.y[side.from];
      const auto& [x_min, x_max, y_min, y_max] = extents[zone];
      const bool own = std::ranges::find(grid.zones[zone], side.from) != grid.zones[zone].end();
      // The box is asked first, because Newton's method for the place in a zone costs far more.
      if (own || x < x_min || x > x_max || y < y_min || y > y_max) continue;
      const auto natural = inverse_bilinear(corners(grid, zone), x, y);
      if (natural && std::abs((*natural)[0]) <= 1 + kReach && std::abs((*natural)[1]) <= 1 + kReach)
        refuse_meeting(grid, path, name_of, side, zone, *natural);
    }
}

void require_one_piece(const Grid& grid, const Edges& edges, const std::string& path,
                       const ZoneName& name_of) {
  std::vector<std::vector<std::uint32_t>> neighbours(edges.list.size());
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z)
    for (const auto edge : edges.of_zone[z]) neighbours[edge].push_back(z);
  std::vector<bool> reached(grid.zones.size(), false);
  std::vector<std::uint32_t> next{0};
  // A list instead of recursion: the way through a large grid would exhaust the stack.
  reached[0] = true;
  while (!next.empty()) {
    const std::uint32_t zone = next.back();
    next.pop_back();
    for (const auto edge : edges.of_zone[zone])
      for (const auto neighbour : neighbours[edge])
        if (!reached[neighbour]) {
          reached[neighbour] = true;
          next.push_back(neighbour);
        }
  }
  const auto lost = std::ranges::find(reached, false);
  if (lost == reached.end()) return;
  const auto zone = static_cast<std::uint32_t>(lost - reached.begin());
  const auto [x, y] = centroid(corners(grid, zone));
  throw UserError(
      path, fmt::format("falls into pieces: {} at ({:.9g}, {:.9g}) m hangs together with {} by no shared "
                        "edges; join the pieces, or make them regions of the scene",
                        name_of(zone), x, y, name_of(0)));
}

}  // namespace

void require_sound(const Grid& grid, const std::string& path, const ZoneName& name_of) {
  require_convex(grid, path, name_of);
  const Edges edges = number_edges(grid);
  require_beside_each_other(grid, edges, path, name_of);
  require_joined(grid, path, name_of);
  require_one_piece(grid, edges, path, name_of);
}

}  // namespace adit::fdm
