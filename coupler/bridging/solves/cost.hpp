// What a multiplier solve cost to set up, and what it keeps in memory.
#pragma once

#include <cstddef>

namespace adit::coupler {

struct SolveCost {
  double factor_seconds = 0;     // assembly and factorization
  std::size_t factor_bytes = 0;  // of the factors
  std::size_t unknowns = 0;      // of the systems that a step solves
};

}  // namespace adit::coupler
