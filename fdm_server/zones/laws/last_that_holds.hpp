// The bisection by which cyclic tests of the ground find a constant or a resistance.
#pragma once

#include <cmath>

namespace adit::fdm {

// The largest value between positive bounds below which a statement holds, to a thousandth: by bisection of
// the logarithm.
template <class Holds>
double last_that_holds(double least, double most, Holds&& holds) {
  while (most > 1.001 * least) {
    const double middle = std::sqrt(least * most);
    (holds(middle) ? least : most) = middle;
  }
  return least;
}

}  // namespace adit::fdm
