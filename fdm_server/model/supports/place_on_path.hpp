// A place on a lining's path.
#pragma once

#include <cmath>
#include <string>

#include "protocol/errors.hpp"
#include "protocol/geometry/shape.hpp"
#include "protocol/messages/structures.pb.h"

namespace adit::fdm {

// Of a joint or dowel: `at`, or the `angle` on a circle. UserError at `path`, its own, where it has not one
// of the two.
template <class Stated>
geometry::Point place_of(const Stated& stated, const scene::LiningPath& along, const std::string& path) {
  using protocol::require;
  require(stated.has_at() != stated.has_angle(), path, "needs one place: give either `at` or `angle`");
  if (stated.has_at()) return {stated.at().x(), stated.at().y()};
  require(along.has_circle(), path + ".angle",
          "counts around a circle, but the lining follows none; give `at` instead");
  const auto& circle = along.circle();
  return {circle.centre().x() + circle.radius() * std::cos(stated.angle()),
          circle.centre().y() + circle.radius() * std::sin(stated.angle())};
}

}  // namespace adit::fdm
