// One exchange with all participants, and the multipliers that correct what they predicted.
#pragma once

#include <functional>
#include <vector>

#include "coupler/exchange/step_cost.hpp"
#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

class RoundTrip {
 public:
  RoundTrip(Model& model, StepCost& cost);

  // Sends the request with the pending corrections, waits for all predictions, and leaves new corrections
  // pending. `meanwhile` is done while the participants compute.
  void run(
      const wire::Advance& request, const std::function<void()>& meanwhile = [] {});

 private:
  void solve();

  Model& model_;
  StepCost& cost_;
  std::vector<Participant*> order_;                  // in which they are asked
  std::vector<double> coarse_, fine_, multipliers_;  // one pair for each coupling point
};

}  // namespace adit::coupler
