// The largest stress, force, strain and slip of any bar, by size and with their signs, over the times that
// are looked at.
#pragma once

#include <cmath>
#include <span>

#include "dem_server/observe/observable.hpp"

namespace adit::dem {

struct BarPeaks {
  struct Peak {
    double value = 0, time = 0, x = 0, y = 0;  // at rest [m]
    void see(double now, double at, double its_x, double its_y) {
      if (std::abs(now) > std::abs(value)) *this = {now, at, its_x, its_y};
    }
  };
  Peak stress, force, strain, slip;  // [Pa], [N], [], [m]

  // At times [s] that ascend.
  void take(std::span<const ObservedBar> bars, double now) {
    for (const ObservedBar& bar : bars) {
      const double x = (bar.x_1 + bar.x_2) / 2, y = (bar.y_1 + bar.y_2) / 2;
      stress.see(bar.stress, now, x, y);
      force.see(bar.pull, now, x, y);
      strain.see(bar.strain, now, x, y);
      slip.see(bar.slip_1, now, bar.x_1, bar.y_1);
      slip.see(bar.slip_2, now, bar.x_2, bar.y_2);
    }
  }
};

}  // namespace adit::dem
