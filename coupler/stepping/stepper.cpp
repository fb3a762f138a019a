#include "coupler/stepping/stepper.hpp"

#include <algorithm>

#include "coupler/stepping/stopwatch.hpp"

namespace adit::coupler {
namespace {

// Participants that compute longer are asked first and heard last, so that the exchange with the others is
// hidden.
void sort_slowest_first(std::vector<Side*>& sides) {
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side* a, const Side* b) { return a->compute_s > b->compute_s; });
}

}  // namespace

Stepper::Stepper(Model& model) : model_(model), ledger_(model.sides) {
  for (Side& side : model.sides) order_.push_back(&side);
  for (auto* vector : {&coarse_, &fine_, &multipliers_}) vector->resize(model.coupling_points.size());
  if (model.substeps > 1) shared_kick_ = std::make_unique<SharedKick>(model, ledger_, cost_);
}

void Stepper::step(std::uint64_t n, Wanted wanted) {
  if (n == 0)  // what statics left has no meaning from rest
    for (Side& side : model_.sides) side.impulses_pending = false;
  if (shared_kick_) {
    shared_kick_->step(n, wanted);
    return;
  }
  request_.Clear();
  request_.set_step(n);
  request_.set_dt(model_.dt);
  request_.set_want_energies(wanted.energies);
  request_.set_want_histories(wanted.histories);
  request_.set_want_peaks(wanted.peaks);
  exchange();
  unbooked_ = true;
  if (wanted.energies) book(true);
}

void Stepper::relax(std::uint64_t n, bool stop, std::uint32_t stage) {
  request_.Clear();
  request_.set_step(n);
  request_.set_dt(model_.dt / model_.substeps);
  request_.set_relax(true);
  request_.set_stop(stop);
  request_.set_stage(stage);
  exchange();
}

// One round trip to all sides, and the multipliers that correct what they predicted.
void Stepper::exchange() {
  {
    const Stopwatch waiting(cost_.wait);
    sort_slowest_first(order_);
    for (Side* side : order_) post_advance(*side, request_);
    book(false);  // the step before, while the participants compute this one
    for (auto side = order_.rbegin(); side != order_.rend(); ++side) receive_prediction(**side);
  }
  if (!model_.constraint) return;
  const Stopwatch solving(cost_.solve);
  Constraint& constraint = *model_.constraint;
  constraint.read(model_.sides, Part::kCoarse, &Side::predicted, coarse_);
  constraint.read(model_.sides, Part::kFine, &Side::predicted, fine_);
  constraint.solve(coarse_, fine_, multipliers_);
  constraint.assign(multipliers_, 1, Part::kCoarse, model_.sides);
  constraint.assign(multipliers_, 1, Part::kFine, model_.sides);
}

void Stepper::book(bool with_energies) {
  if (!unbooked_) return;
  unbooked_ = false;
  if (model_.constraint) {
    for (Side& side : model_.sides) correct_velocities(side);
    model_.constraint->read(model_.sides, Part::kCoarse, &Side::corrected, coarse_);
    model_.constraint->read(model_.sides, Part::kFine, &Side::corrected, fine_);
    ledger_.book_gap(coarse_, fine_);
  }
  for (std::size_t s = 0; s < model_.sides.size(); ++s) {
    if (with_energies) ledger_.take_energies(s, model_.sides[s]);
    ledger_.close_step(s, model_.sides[s]);
  }
  if (with_energies) ledger_.compare();
}

}  // namespace adit::coupler
