#include "fdm_server/model/grid/read_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/geometry/read_shape.hpp"

namespace adit::fdm {
namespace {

using protocol::UserError;
using Sides = std::array<Side, 4>;
constexpr double kPi = std::numbers::pi;

Point read(const scene::Point& point) {
  return {point.x(), point.y()};
}

double distance(const Point& a, const Point& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

// The angle at `centre` from `a` to `b`, in (-pi, pi].
double angle(const Point& centre, const Point& a, const Point& b) {
  const double ax = a.x - centre.x, ay = a.y - centre.y, bx = b.x - centre.x, by = b.y - centre.y;
  return std::atan2(ax * by - ay * bx, ax * bx + ay * by);
}

Division read(const scene::Division& division, const std::string& path) {
  constexpr double kSmallest = 1e-6;
  const double ratio = division.ratio();
  const double powers = division.from_both_ends() ? (division.zones() - 1) / 2 : division.zones() - 1.0;
  if (std::abs(std::log(ratio)) * powers > -std::log(kSmallest))
    throw UserError(path + ".ratio",
                    fmt::format("is {:g} over {} zones; give one that leaves the smallest zone at least "
                                "{:g} of the largest",
                                ratio, division.zones(), kSmallest));
  return {division.zones(), ratio, division.from_both_ends()};
}

// The circle through three points; the way from `a` to `b` that passes `through`.
Side arc_through(const Point& a, const Point& b, const Point& through, const std::string& path) {
  const double bx = b.x - a.x, by = b.y - a.y, tx = through.x - a.x, ty = through.y - a.y;
  const double twice = 2 * (bx * ty - by * tx), bb = bx * bx + by * by, tt = tx * tx + ty * ty;
  const Point centre{a.x + (ty * bb - by * tt) / twice, a.y + (bx * tt - tx * bb) / twice};
  const double radius = distance(centre, a);
  if (!(radius < 1e6 * std::sqrt(bb)))
    throw UserError(path, "lies in line with the side's corners; leave the arc out for a straight side");
  const double to_through = angle(centre, a, through);
  double sweep = angle(centre, a, b);
  const auto turn = [](double any) { return any < 0 ? any + 2 * kPi : any; };
  if (turn(to_through) < turn(sweep))
    sweep = turn(sweep);
  else
    sweep = turn(sweep) - 2 * kPi;
  return {a, b, centre, sweep};
}

Side read(const scene::Arc& arc, const Point& a, const Point& b, const std::string& path) {
  if (arc.has_through()) return arc_through(a, b, read(arc.through()), path + ".through");
  if (!arc.has_centre())
    throw UserError(path, "is not known; give a point `through` which it leads, or its `centre`");
  const Point centre = read(arc.centre());
  const double from = distance(centre, a), to = distance(centre, b);
  if (!(std::abs(from - to) <= 1e-6 * std::max(from, to)))
    throw UserError(path + ".centre",
                    fmt::format("is {:.9g} m from one corner of the side and {:.9g} m from the other; "
                                "let both be the radius",
                                from, to));
  return {a, b, centre, angle(centre, a, b)};
}

Sides read_quadrilateral(const scene::Quadrilateral& given, const std::string& path) {
  std::array<Point, 4> c;
  for (int i = 0; i < 4; ++i) c[i] = read(given.corners(i));
  const std::array<std::array<int, 2>, 4> ends{{{0, 1}, {1, 2}, {3, 2}, {0, 3}}};
  Sides sides;
  for (int s = 0; s < 4; ++s) {
    const auto [from, to] = ends[s];
    if (!(distance(c[from], c[to]) > 0))
      throw UserError(fmt::format("{}.corners[{}]", path, to),
                      "is the same place as its neighbour; give 4 corners");
    sides[s] = Side(c[from], c[to]);
  }
  for (int i = 0; i < given.arcs_size(); ++i) {
    const auto [from, to] = ends[given.arcs(i).side()];
    sides[given.arcs(i).side()] = read(given.arcs(i), c[from], c[to], fmt::format("{}.arcs[{}]", path, i));
  }
  return sides;
}

// A quarter of a circle or a side of a square, counter-clockwise from the corner at the angle `first`.
Side quarter(const Point& centre, bool circle, double size, double first) {
  const double reach = circle ? size : size * std::numbers::sqrt2 / 2;
  const auto at = [&](double direction) {
    return Point{centre.x + reach * std::cos(direction), centre.y + reach * std::sin(direction)};
  };
  const Point from = at(first), to = at(first + kPi / 2);
  return circle ? Side(from, to, centre, kPi / 2) : Side(from, to);
}

std::vector<Sides> read_ring(const scene::Ring& ring, const std::string& path) {
  const Point centre = read(ring.centre());
  if (ring.inner_case() == scene::Ring::INNER_NOT_SET)
    throw UserError(path, "has no inside; give inner_radius or inner_side");
  if (ring.outer_case() == scene::Ring::OUTER_NOT_SET)
    throw UserError(path, "has no outside; give outer_radius or outer_side");
  const double inner = ring.has_inner_radius() ? ring.inner_radius() : ring.inner_side();
  const double outer = ring.has_outer_radius() ? ring.outer_radius() : ring.outer_side();
  // furthest inner and nearest outer points
  const double reach = ring.has_inner_radius() ? inner : inner * std::numbers::sqrt2 / 2;
  const double begin = ring.has_outer_radius() ? outer : outer / 2;
  const bool both_squares = ring.has_inner_side() && ring.has_outer_side();
  if (!(both_squares ? outer > inner : begin > reach))
    throw UserError(
        path, fmt::format("has its inside, {:g} m wide, not within its outside, {:g} m wide; let it lie "
                          "inside everywhere",
                          ring.has_inner_radius() ? 2 * inner : inner,
                          ring.has_outer_radius() ? 2 * outer : outer));
  std::vector<Sides> quarters;
  for (int q = 0; q < 4; ++q) {
    const double first = (2 * q - 1) * kPi / 4;
    const Side lower = quarter(centre, ring.has_inner_radius(), inner, first);
    const Side upper = quarter(centre, ring.has_outer_radius(), outer, first);
    quarters.push_back({lower, Side(lower.at(1), upper.at(1)), upper, Side(lower.at(0), upper.at(0))});
  }
  return quarters;
}

}  // namespace

std::vector<MappedBlock> read_blocks(const scene::GridBlock& block, const std::string& path) {
  std::vector<Sides> parts;
  Division along = read(block.along(), path + ".along");
  const Division across = read(block.across(), path + ".across");
  switch (block.shape_case()) {
    case scene::GridBlock::kRectangle: {
      const auto c = corners(geometry::read_bounds(block.rectangle()));
      parts = {{Side(c[0], c[1]), Side(c[1], c[2]), Side(c[3], c[2]), Side(c[0], c[3])}};
      break;
    }
    case scene::GridBlock::kQuadrilateral:
      parts = {read_quadrilateral(block.quadrilateral(), path + ".quadrilateral")};
      break;
    case scene::GridBlock::kRing:
      parts = read_ring(block.ring(), path + ".ring");
      if (along.zones % 4 != 0)
        throw UserError(path + ".along.zones",
                        fmt::format("is {}; give a multiple of 4, so that a ring has points at its corners",
                                    along.zones));
      along.zones /= 4;
      break;
    case scene::GridBlock::SHAPE_NOT_SET:
      throw UserError(path, "has no shape; give it a rectangle, a quadrilateral or a ring");
  }
  std::vector<MappedBlock> blocks;
  for (const Sides& sides : parts) blocks.push_back({block.name(), sides, along, across});
  return blocks;
}

}  // namespace adit::fdm
