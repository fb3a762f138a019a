// Reads shapes from the scene.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "protocol/geometry/shape.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::geometry {

// Takes messages that fulfil their rules. `path` is the shape's path in the scene. Throws protocol::UserError
// if the shape encloses no area or crosses itself, if a hole does not lie inside it, or if a band has no
// length.
std::shared_ptr<const Shape> read_shape(const scene::Shape& shape, const std::string& path);
BoundingBox read_bounds(const scene::Box& box);
std::shared_ptr<const Shape> read_circle(const scene::Circle& circle);
std::shared_ptr<const Shape> read_annulus(const scene::Annulus& annulus);
std::array<Point, 4> read_band_corners(const scene::Band& band, const std::string& path);
std::shared_ptr<const Shape> read_band(const scene::Band& band, const std::string& path);
std::shared_ptr<const Shape> read_polygon(const scene::Polygon& polygon, const std::string& path);

}  // namespace adit::geometry
