// The largest opening of any crack between cells of a group over the times that are looked at.
#pragma once

#include <span>

#include "dem_server/observe/observable.hpp"

namespace adit::dem {

struct WidestCrack {
  double width = 0, time = 0, x = 0, y = 0;  // [m], [s], its middle in the body at rest [m]

  // At times [s] that ascend.
  void take(std::span<const ObservedCrack> cracks, double now) {
    for (const ObservedCrack& crack : cracks)
      if (!crack.debonded && crack.opening > width)
        *this = {crack.opening, now, crack.middle().x, crack.middle().y};
  }
};

}  // namespace adit::dem
