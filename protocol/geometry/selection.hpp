// Selects points by an area of the scene.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "protocol/geometry/shape.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// The places of an area; a group that it also names is left to the caller.
class Places {
 public:
  // `tolerance` [m] widens every boundary. Throws UserError below `path` if a polygon encloses no area or a
  // band has no length.
  Places(const scene::Area& area, const std::string& path, double tolerance);

  // Whether (x, y) lies inside or on the boundary of every shape of the area.
  bool hold(double x, double y) const;
  // From the farthest of the shapes, negative inside all of them; no point of the area is nearer [m].
  double distance(double x, double y) const;

 private:
  scene::Area area_;
  double tolerance_;
  std::vector<std::shared_ptr<const geometry::Shape>> shapes_;
};

// Indices of the points (x0 y0 x1 y1 …) that the area selects, ascending, in a model without groups. Throws
// UserError at `path` if it selects none; `what` names the points in the message ("particles").
std::vector<std::uint32_t> select(const scene::Area& area, std::span<const double> points, double tolerance,
                                  const std::string& path, const std::string& what);

// Throws the UserError of an area that selects nothing.
[[noreturn]] void refuse_empty(const std::string& path, const std::string& what);

}  // namespace adit::protocol
