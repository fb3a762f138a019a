#include "dem_server/model/placement/crossed.hpp"

#include <algorithm>
#include <cmath>

namespace adit::dem {
namespace {

using geometry::Point;

// Shares of a piece between which it lies in a particle; empty where begin >= end.
struct Part {
  double begin = 0, end = 1;
};

// From `a`, both about the nucleus, by the vector `way`: cut by each side, of which the cell lies on the
// left.
Part within_cell(const Point& a, const Point& way, const CellOutline& outline) {
  Part part;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Point &from = outline[k], &to = outline[(k + 1) % outline.size()];
    const double nx = -(to.y - from.y), ny = to.x - from.x;
    const double inside = nx * (a.x - from.x) + ny * (a.y - from.y), speed = nx * way.x + ny * way.y;
    if (speed == 0 && inside < 0) return {1, 0};
    if (speed > 0) part.begin = std::max(part.begin, -inside / speed);
    if (speed < 0) part.end = std::min(part.end, -inside / speed);
  }
  return part;
}

Part within_disc(const Point& a, const Point& way, double radius) {
  const double square = way.x * way.x + way.y * way.y, nearest = -(a.x * way.x + a.y * way.y) / square;
  const double beside = (a.x * a.x + a.y * a.y) - nearest * nearest * square, room = radius * radius - beside;
  if (room <= 0) return {1, 0};
  const double half = std::sqrt(room / square);
  return {std::max(0.0, nearest - half), std::min(1.0, nearest + half)};
}

// How far a particle reaches from its centre.
std::vector<double> reaches(const Model& model) {
  std::vector<double> reach = model.discs.radius;
  for (std::size_t i = 0; i < model.outlines.size(); ++i)
    for (const Point& corner : model.outlines[i])
      reach[i] = std::max(reach[i], std::hypot(corner.x, corner.y));
  return reach;
}

// A particle whose part of one piece meets its part of the next is crossed once.
std::vector<Crossed> joined(std::vector<Crossed> parts, double rounding) {
  std::ranges::sort(parts, [](const Crossed& a, const Crossed& b) {
    return a.middle() < b.middle() || (a.middle() == b.middle() && a.disc < b.disc);
  });
  std::vector<Crossed> found;
  for (const Crossed& part : parts)
    if (!found.empty() && found.back().disc == part.disc && part.begin <= found.back().end + rounding)
      found.back().end = part.end;
    else
      found.push_back(part);
  return found;
}

double distance(const Point& a, const Point& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

}  // namespace

std::vector<Crossed> crossed_by(std::span<const Point> line, const Model& model) {
  constexpr double kRounding = 1e-9;  // of a length; shorter parts touch a corner
  const std::vector<double> reach = reaches(model);
  const double rounding = kRounding * length_of(line);
  std::vector<Crossed> parts;
  double before = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Point way{line[k + 1].x - line[k].x, line[k + 1].y - line[k].y};
    const double length = distance(line[k], line[k + 1]);
    for (std::uint32_t i = 0; i < model.discs.size(); ++i) {
      const Point a{line[k].x - model.discs.x[i], line[k].y - model.discs.y[i]};
      if (std::abs(a.x + way.x / 2) > std::abs(way.x / 2) + reach[i] ||
          std::abs(a.y + way.y / 2) > std::abs(way.y / 2) + reach[i])
        continue;
      const Part part = model.outlines.empty() ? within_disc(a, way, model.discs.radius[i])
                                               : within_cell(a, way, model.outlines[i]);
      if ((part.end - part.begin) * length > rounding)
        parts.push_back({i, before + part.begin * length, before + part.end * length});
    }
    before += length;
  }
  return joined(std::move(parts), rounding);
}

Point place_on(std::span<const Point> line, double at) {
  if (at < 0) at += length_of(line);
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double length = distance(line[k], line[k + 1]);
    if (at <= length || k + 2 == line.size()) {
      const double share = at / length;
      return {line[k].x + share * (line[k + 1].x - line[k].x),
              line[k].y + share * (line[k + 1].y - line[k].y)};
    }
    at -= length;
  }
  return line.back();
}

double length_of(std::span<const Point> line) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) sum += distance(line[k], line[k + 1]);
  return sum;
}

}  // namespace adit::dem
