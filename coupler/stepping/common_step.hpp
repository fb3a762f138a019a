// All participants take the same step: they predict, the multipliers are solved for, they correct. The
// correction of step n − 1 and the prediction of step n ride in the same message: one round trip a step.
#pragma once

#include <cstdint>
#include <vector>

#include "coupler/exchange/round_trip.hpp"
#include "coupler/stepping/ledger.hpp"
#include "coupler/stepping/time_scheme.hpp"

namespace adit::coupler {

class CommonStep : public TimeScheme {
 public:
  CommonStep(Model& model, RoundTrip& round_trip, Ledger& ledger);

  void step(std::uint64_t n, Wanted wanted) override;
  void exchange(state::Archive& archive) override { archive("unbooked", unbooked_); }

 private:
  void book(bool with_energies);

  Model& model_;
  RoundTrip& round_trip_;
  Ledger& ledger_;
  wire::Advance request_;
  std::vector<double> coarse_, fine_;  // corrected, one pair for each coupling point
  bool unbooked_ = false;              // the last step is not yet in the ledger
};

}  // namespace adit::coupler
