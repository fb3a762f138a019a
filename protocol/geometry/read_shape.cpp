#include "protocol/geometry/read_shape.hpp"

#include <fmt/format.h>

#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/geometry/polygon.hpp"

namespace adit::geometry {
namespace {

using protocol::UserError;
using Corners = google::protobuf::RepeatedPtrField<scene::Point>;

std::shared_ptr<const Shape> read_box(const scene::Box& box) {
  const auto four = corners(read_bounds(box));
  return polygon({Loop(four.begin(), four.end())});
}

Loop read_corners(const Corners& corners, const std::string& path) {
  Loop loop;
  for (const scene::Point& corner : corners) loop.push_back({corner.x(), corner.y()});
  if (!is_simple(loop))
    throw UserError(path,
                    "names a corner twice, or sides that cross, touch or run back over one another; give the "
                    "corners in order around the area");
  return loop;
}

bool encloses(const Loop& loop, const Loop& other) {
  return signed_distance(sides(loop), other.front()) < 0;
}

}  // namespace

BoundingBox read_bounds(const scene::Box& box) {
  return {box.x_min(), box.x_max(), box.y_min(), box.y_max()};
}

std::shared_ptr<const Shape> read_circle(const scene::Circle& circle) {
  return disc(circle.centre().x(), circle.centre().y(), circle.radius());
}

std::shared_ptr<const Shape> read_annulus(const scene::Annulus& given) {
  return annulus(given.centre().x(), given.centre().y(), given.inner_radius(), given.outer_radius());
}

std::array<Point, 4> read_band_corners(const scene::Band& band, const std::string& path) {
  const double dx = band.to().x() - band.from().x(), dy = band.to().y() - band.from().y();
  const double length = std::hypot(dx, dy);
  if (!(length > 0)) throw UserError(path + ".to", "is the same place as `from`; give a band two ends");
  const double nx = -dy / length * band.width() / 2, ny = dx / length * band.width() / 2;
  return {{{band.from().x() - nx, band.from().y() - ny},
           {band.to().x() - nx, band.to().y() - ny},
           {band.to().x() + nx, band.to().y() + ny},
           {band.from().x() + nx, band.from().y() + ny}}};
}

std::shared_ptr<const Shape> read_band(const scene::Band& band, const std::string& path) {
  const auto four = read_band_corners(band, path);
  return polygon({{four.begin(), four.end()}});
}

std::shared_ptr<const Shape> read_polygon(const scene::Polygon& given, const std::string& path) {
  std::vector<Loop> loops = {read_corners(given.corners(), path + ".corners")};
  for (int i = 0; i < given.holes_size(); ++i) {
    const std::string hole_path = fmt::format("{}.holes[{}].corners", path, i);
    const Loop hole = read_corners(given.holes(i).corners(), hole_path);
    for (const Loop& loop : loops)
      if (meet(loop, hole))
        throw UserError(hole_path,
                        "meets the polygon's boundary or another hole; give a hole that lies apart");
    if (!encloses(loops.front(), hole))
      throw UserError(hole_path, "lies outside the polygon; give a hole inside it");
    for (std::size_t k = 1; k < loops.size(); ++k)
      if (encloses(loops[k], hole) || encloses(hole, loops[k]))
        throw UserError(hole_path,
                        fmt::format("and holes[{}] lie in one another; keep the larger one", k - 1));
    loops.push_back(hole);
  }
  return polygon(loops);
}

std::shared_ptr<const Shape> read_shape(const scene::Shape& shape, const std::string& path) {
  switch (shape.shape_case()) {
    case scene::Shape::kBox:
      return read_box(shape.box());
    case scene::Shape::kCircle:
      return read_circle(shape.circle());
    case scene::Shape::kPolygon:
      return read_polygon(shape.polygon(), path + ".polygon");
    case scene::Shape::SHAPE_NOT_SET:
      break;
  }
  throw UserError(path, "names no shape; give a box, a circle or a polygon");
}

}  // namespace adit::geometry
