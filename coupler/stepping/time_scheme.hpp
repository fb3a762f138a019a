#pragma once

#include <cstdint>

#include "coupler/exchange/wanted.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

// How the participants come from one step of the model to the next: all take the same step (common_step.hpp),
// or particles take several in one of the continuum (shared_kick.hpp).
class TimeScheme {
 public:
  virtual ~TimeScheme() = default;
  // To step n = 0, 1, 2 …
  virtual void step(std::uint64_t n, Wanted wanted) = 0;
  // What passes from one step to the next, besides what the participants and the ledger know.
  virtual void exchange(state::Archive& archive) = 0;
};

}  // namespace adit::coupler
