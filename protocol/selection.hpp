// Selecting by a box of the scene.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "protocol/scene.pb.h"

namespace adit::protocol {

// Whether (x, y) lies inside or on the box, within `tolerance` [m].
bool inside(const scene::Box& box, double x, double y, double tolerance);

// Indices of the points (x0 y0 x1 y1 …) that the box selects, ascending. Selecting nothing is the user's
// error, reported at `path`; `what` names the points in the message ("grid points", "particles").
std::vector<std::uint32_t> select(const scene::Box& box, std::span<const double> points, double tolerance,
                                  const std::string& path, const std::string& what);

}  // namespace adit::protocol
