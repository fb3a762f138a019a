// The area of parallel bars as scenes state it: by their spacing, or itself.
#pragma once

#include <numbers>
#include <string>

#include "protocol/errors.hpp"

namespace adit::sections {

// Of one bar [m^2].
inline double bar_area(double diameter) {
  return std::numbers::pi / 4 * diameter * diameter;
}

// Per metre [m^2/m]. UserError at `path` where it is stated twice or not at all.
template <class Bars>
double bars_area(const Bars& bars, const std::string& path) {
  protocol::require(bars.has_spacing() != bars.has_area(), path,
                    "needs its steel once: give either `spacing` or `area`");
  return bars.has_area() ? bars.area() : bar_area(bars.diameter()) / bars.spacing();
}

}  // namespace adit::sections
