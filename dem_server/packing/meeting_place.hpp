// Where two discs meet.
#pragma once

#include <cmath>
#include <cstdint>

namespace adit::dem {

struct Place {
  double x, y;  // [m]
};

// The middle of the gap or overlap of two of some discs at rest, which have columns x, y and radius.
template <class SomeDiscs>
Place meeting_place(const SomeDiscs& d, std::uint32_t i, std::uint32_t j) {
  const double dx = d.x[j] - d.x[i], dy = d.y[j] - d.y[i];
  const double shift = (d.radius[i] - d.radius[j]) / (2 * std::hypot(dx, dy));
  return {0.5 * (d.x[i] + d.x[j]) + shift * dx, 0.5 * (d.y[i] + d.y[j]) + shift * dy};
}

}  // namespace adit::dem
