// What paths of linings and bars must be. Each throws protocol::UserError below `path`, the path's own in the
// scene.
#pragma once

#include <string>
#include <vector>

#include "protocol/geometry/shape.hpp"
#include "protocol/messages/structures.pb.h"

namespace adit::geometry {

// A whole circle, or both ends of an arc in their order.
void require_arc(const scene::RoundPath& circle, const std::string& path);
// Points of a line that passes every place once.
void require_simple(const std::vector<Point>& points, const std::string& path);

}  // namespace adit::geometry
