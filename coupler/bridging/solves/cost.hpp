// The cost of a multiplier solve: the time for setting it up, and its memory.
#pragma once

#include <cstddef>

namespace adit::coupler {

struct SolveCost {
  double factor_seconds = 0;     // assembly and factorization
  std::size_t factor_bytes = 0;  // memory of the factors
  std::size_t unknowns = 0;      // unknowns of all systems that are solved in a step
};

}  // namespace adit::coupler
