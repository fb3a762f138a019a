#include "coupler/exchange/round_trip.hpp"

#include <algorithm>

#include "coupler/exchange/exchange.hpp"

namespace adit::coupler {
namespace {

// Participants that compute longer are asked first and heard last, so that the exchange with the others is
// hidden.
void sort_slowest_first(std::vector<Participant*>& participants) {
  std::stable_sort(participants.begin(), participants.end(),
                   [](const Participant* a, const Participant* b) { return a->compute_s > b->compute_s; });
}

}  // namespace

RoundTrip::RoundTrip(Model& model, StepCost& cost) : model_(model), cost_(cost) {
  for (Participant& participant : model.participants) order_.push_back(&participant);
  for (auto* vector : {&coarse_, &fine_, &multipliers_}) vector->resize(model.coupling_points.size());
}

void RoundTrip::run(const wire::Advance& request, const std::function<void()>& meanwhile) {
  {
    const Stopwatch waiting(cost_.wait);
    sort_slowest_first(order_);
    for (Participant* participant : order_) post_advance(*participant, request);
    meanwhile();
    for (auto participant = order_.rbegin(); participant != order_.rend(); ++participant)
      receive_prediction(**participant);
  }
  if (model_.constraint) solve();
}

void RoundTrip::solve() {
  const Stopwatch solving(cost_.solve);
  Constraint& constraint = *model_.constraint;
  constraint.read(model_.participants, Part::kCoarse, &Participant::predicted, coarse_);
  constraint.read(model_.participants, Part::kFine, &Participant::predicted, fine_);
  constraint.solve(coarse_, fine_, multipliers_);
  for (const Part part : {Part::kCoarse, Part::kFine})
    constraint.assign(multipliers_, 1, part, model_.participants);
}

}  // namespace adit::coupler
