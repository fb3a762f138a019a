// Random overlaps of every kind.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/overlaps.hpp"

namespace adit::test {

inline double random_between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

// A shape of about 2 m across near the origin.
inline std::string random_convex_shape() {
  const double x = random_between(-0.3, 0.3), y = random_between(-0.3, 0.3), size = random_between(0.7, 1.2);
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return box(x - size, x + size * random_between(0.5, 1), y - size * random_between(0.5, 1), y + size);
    case 1:
      return circle(x, y, size);
    default:
      return "polygon { " + star(x, y, size, *rc::gen::inRange(3, 9), random_between(0, 6), 1) + "}";
  }
}

inline std::string random_shape() {
  if (*rc::gen::inRange(0, 2) == 0) return random_convex_shape();
  const double x = random_between(-0.3, 0.3), y = random_between(-0.3, 0.3);
  return "polygon { " + star(x, y, random_between(0.9, 1.2), 10, random_between(0, 6), 0.7) + "holes { " +
         star(x, y, random_between(0.2, 0.4), 6, random_between(0, 6), 0.8) + "} }";
}

inline std::string random_strip() {
  const double x = random_between(-1, 1), y = random_between(-1, 1), width = random_between(0.2, 1),
               angle = random_between(0, 6);
  return strip(x, y, x + width * std::cos(angle), y + width * std::sin(angle));
}

inline std::string random_overlap() {
  return *rc::gen::inRange(0, 3) == 0 ? random_strip() : ring(random_shape(), random_between(0.1, 1));
}

}  // namespace adit::test
