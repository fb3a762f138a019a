#include "coupler/tunnel/opening.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupler/tunnel/parts.hpp"

namespace adit::coupler {
namespace {

using geometry::Point;
using std::numbers::pi;

double gap(const Point& a, const Point& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

Point between(const Point& a, const Point& b, double share) {
  return {std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share)};
}

std::uint32_t at_least_one(double number) {
  return static_cast<std::uint32_t>(std::max(1.0, std::round(number)));
}

scene::GridBlock block_between(const std::array<Point, 2>& inner, const std::array<Point, 2>& outer,
                               std::uint32_t along, std::uint32_t across) {
  scene::GridBlock block;
  for (const Point& corner : {inner[0], inner[1], outer[1], outer[0]})
    *block.mutable_quadrilateral()->add_corners() = point(corner);
  block.mutable_along()->set_zones(along);
  block.mutable_across()->set_zones(across);
  return block;
}

// Zones over a distance that grow evenly from one size to another.
struct Growth {
  std::uint32_t zones;
  double ratio;
};
Growth growth(double distance, double first, double last) {
  const double factor = last / first;
  const bool equal = std::abs(factor - 1) < 1e-6;
  const std::uint32_t zones =
      at_least_one(equal ? distance / first : distance * std::log(factor) / (last - first));
  return {zones, equal || zones == 1 ? 1.0 : std::pow(factor, 1.0 / (zones - 1))};
}

}  // namespace

Opening::Opening(const scene::LinedTunnel& tunnel, const Contour& contour, const HostBlock& host,
                 const ZoneRange& zones)
    : contour_(contour),
      zones_(zones),
      rectangle_{{{host.x(zones.right), host.y(zones.lower)},
                  {host.x(zones.right), host.y(zones.upper)},
                  {host.x(zones.left), host.y(zones.upper)},
                  {host.x(zones.left), host.y(zones.lower)}}},
      zone_width_(host.zone_width()),
      zone_height_(host.zone_height()),
      parts_(parts_of(tunnel)) {
  for (const Part& part : parts_) size_ += part.zones;
}

geometry::BoundingBox Opening::extent() const {
  return {rectangle_[3].x, rectangle_[1].x, rectangle_[3].y, rectangle_[1].y};
}

std::uint32_t Opening::along(std::size_t side) const {
  return side % 2 == 0 ? zones_.upper - zones_.lower : zones_.right - zones_.left;
}

std::vector<Opening::Part> Opening::parts_of(const scene::LinedTunnel& tunnel) const {
  if (tunnel.has_circle()) return parts_of_circle();
  return tunnel.has_horseshoe() ? parts_of_horseshoe() : parts_of_box();
}

// Each side of the rectangle faces an arc, by its share of all zones.
std::vector<Opening::Part> Opening::parts_of_circle() const {
  const double half = pi * along(0) / (2.0 * (along(0) + along(1)));
  const std::array<double, 5> angles{-half, half, pi - half, pi + half, 2 * pi - half};
  std::vector<Part> parts;
  for (std::size_t side = 0; side < 4; ++side)
    parts.push_back({{true, angles[side]}, {true, angles[side + 1]}, side, 0, along(side)});
  return parts;
}

// The right and the left side face a wall and a part of the arch. All zones along walls and arch are about as
// long.
std::vector<Opening::Part> Opening::parts_of_horseshoe() const {
  const std::uint32_t rows = along(0), columns = along(1);
  const double wall = gap(contour_.wall_end(1, -1, 0), contour_.wall_end(1, 0, 0)),
               arch = gap(contour_.centre(), contour_.on_arc(0, 0)) * pi;
  const double whole = 2 * wall + arch, zones = 2.0 * rows + columns;
  const std::uint32_t of_wall = std::clamp(at_least_one(wall / whole * zones), 1u, rows - 1);
  const std::uint32_t above = rows - of_wall;
  const double corner = pi * above / (2.0 * above + columns);
  const End lower_right{false, 0, 1, -1}, right{false, 0, 1, 0}, left{false, 0, -1, 0},
      lower_left{false, 0, -1, -1};
  return {{lower_right, right, 0, 0, of_wall},
          {{true, 0}, {true, corner}, 0, of_wall, above},
          {{true, corner}, {true, pi - corner}, 1, 0, columns},
          {{true, pi - corner}, {true, pi}, 2, 0, above},
          {left, lower_left, 2, above, of_wall},
          {lower_left, lower_right, 3, 0, columns}};
}

std::vector<Opening::Part> Opening::parts_of_box() const {
  const std::array<End, 4> corners{
      {{false, 0, 1, -1}, {false, 0, 1, 1}, {false, 0, -1, 1}, {false, 0, -1, -1}}};
  std::vector<Part> parts;
  for (std::size_t side = 0; side < 4; ++side)
    parts.push_back({corners[side], corners[(side + 1) % 4], side, 0, along(side)});
  return parts;
}

Point Opening::place(const End& end, double offset) const {
  return end.on_arc ? contour_.on_arc(end.angle, offset) : contour_.wall_end(end.right, end.up, offset);
}

std::vector<Point> Opening::nodes(double offset) const {
  std::vector<Point> nodes;
  for (const Part& part : parts_)
    for (std::uint32_t zone = 0; zone < part.zones; ++zone) {
      const double share = static_cast<double>(zone) / part.zones;
      nodes.push_back(part.is_arc()
                          ? contour_.on_arc(std::lerp(part.from.angle, part.to.angle, share), offset)
                          : between(place(part.from, offset), place(part.to, offset), share));
    }
  return nodes;
}

double Opening::side(double offset) const {
  const auto all = nodes(offset);
  double length = 0;
  for (std::size_t k = 0; k < all.size(); ++k) length += gap(all[k], all[(k + 1) % all.size()]);
  return length / static_cast<double>(all.size());
}

scene::LiningPath Opening::path(double offset) const {
  scene::LiningPath path;
  const auto all = nodes(offset);
  if (contour_.shape(0).has_circle()) {
    auto& circle = *path.mutable_circle();
    *circle.mutable_centre() = point(contour_.centre());
    circle.set_radius(gap(contour_.centre(), all[0]));
    circle.set_from(parts_.front().from.angle);
    circle.set_to(parts_.front().from.angle + 2 * pi);
    return path;
  }
  for (const Point& node : all) *path.mutable_line()->add_points() = point(node);
  *path.mutable_line()->add_points() = point(all.front());
  return path;
}

std::array<Point, 2> Opening::faced(const Part& part, const Corners& corners) const {
  const Point &from = corners[part.facing], &to = corners[(part.facing + 1) % 4];
  const double all = along(part.facing);
  return {between(from, to, part.first / all), between(from, to, (part.first + part.zones) / all)};
}

void Opening::add_arc(const Part& part, scene::Arc::Side side, scene::Quadrilateral& shape) const {
  if (!part.is_arc()) return;
  scene::Arc& arc = *shape.add_arcs();
  arc.set_side(side);
  *arc.mutable_centre() = point(contour_.centre());
}

std::vector<scene::GridBlock> Opening::ring(double inner, double outer, std::uint32_t across) const {
  std::vector<scene::GridBlock> blocks;
  for (const Part& part : parts_) {
    blocks.push_back(block_between({place(part.from, inner), place(part.to, inner)},
                                   {place(part.from, outer), place(part.to, outer)}, part.zones, across));
    add_arc(part, scene::Arc::LOWER, *blocks.back().mutable_quadrilateral());
    add_arc(part, scene::Arc::UPPER, *blocks.back().mutable_quadrilateral());
  }
  return blocks;
}

double Opening::distance(const Corners& corners, double offset) const {
  double sum = 0;
  for (const Part& part : parts_) {
    const auto ends = faced(part, corners);
    const Point middle = part.is_arc() ? contour_.on_arc((part.from.angle + part.to.angle) / 2, offset)
                                       : between(place(part.from, offset), place(part.to, offset), 0.5);
    sum += part.zones * gap(middle, between(ends[0], ends[1], 0.5));
  }
  return sum / static_cast<double>(size_);
}

std::vector<scene::GridBlock> Opening::surroundings(double offset) const {
  const auto [zones, ratio] =
      growth(distance(rectangle_, offset), side(offset), (zone_width_ + zone_height_) / 2);
  std::vector<scene::GridBlock> blocks;
  for (const Part& part : parts_) {
    blocks.push_back(block_between({place(part.from, offset), place(part.to, offset)},
                                   faced(part, rectangle_), part.zones, zones));
    blocks.back().mutable_across()->set_ratio(ratio);
    add_arc(part, scene::Arc::LOWER, *blocks.back().mutable_quadrilateral());
  }
  return blocks;
}

// Its corners lie at four fifths of the way from the middle to the places on the outline that face those of
// the rectangle, so that its zones are about as large as the others.
Opening::Corners Opening::core(double offset) const {
  constexpr double kShare = 0.8;
  const auto [x_min, x_max, y_min, y_max] = contour_.box(offset);
  const Point middle{(x_min + x_max) / 2, (y_min + y_max) / 2};
  Corners corners{};
  for (const Part& part : parts_)
    if (part.first == 0) corners[part.facing] = between(middle, place(part.from, offset), kShare);
  return corners;
}

std::vector<scene::GridBlock> Opening::inside(double offset) const {
  const bool round = std::ranges::any_of(parts_, &Part::is_arc);
  if (!round) {
    const auto [x_min, x_max, y_min, y_max] = contour_.box(offset);
    return {block_between({{{x_min, y_min}, {x_max, y_min}}}, {{{x_min, y_max}, {x_max, y_max}}}, along(1),
                          along(0))};
  }
  const Corners core = this->core(offset);
  std::vector<scene::GridBlock> blocks{
      block_between({core[3], core[0]}, {core[2], core[1]}, along(1), along(0))};
  const std::uint32_t across = at_least_one(distance(core, offset) / side(offset));
  for (const Part& part : parts_) {
    blocks.push_back(block_between(faced(part, core), {place(part.from, offset), place(part.to, offset)},
                                   part.zones, across));
    add_arc(part, scene::Arc::UPPER, *blocks.back().mutable_quadrilateral());
  }
  return blocks;
}

}  // namespace adit::coupler
