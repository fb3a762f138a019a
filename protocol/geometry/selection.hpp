// Selecting by an area of the scene.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "protocol/geometry/shape.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// The places of an area, whatever group it also names.
class Places {
 public:
  // UserError below `path` for a polygon that encloses no area. `tolerance` [m] widens every line.
  Places(const scene::Area& area, const std::string& path, double tolerance);

  // Whether (x, y) lies inside or on all that the area gives.
  bool hold(double x, double y) const;

 private:
  scene::Area area_;
  double tolerance_;
  std::vector<std::shared_ptr<const geometry::Shape>> shapes_;
};

// Indices of the points (x0 y0 x1 y1 …) that the area selects, ascending, in a model without groups.
// Selecting nothing is the user's error, reported at `path`; `what` names the points in the message
// ("particles").
std::vector<std::uint32_t> select(const scene::Area& area, std::span<const double> points, double tolerance,
                                  const std::string& path, const std::string& what);

// Throws the UserError of an area that selects nothing.
[[noreturn]] void refuse_empty(const std::string& path, const std::string& what);

}  // namespace adit::protocol
