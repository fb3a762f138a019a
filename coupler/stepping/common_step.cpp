#include "coupler/stepping/common_step.hpp"

#include "coupler/exchange/exchange.hpp"

namespace adit::coupler {

CommonStep::CommonStep(Model& model, RoundTrip& round_trip, Ledger& ledger)
    : model_(model), round_trip_(round_trip), ledger_(ledger) {
  for (auto* vector : {&coarse_, &fine_}) vector->resize(model.coupling_points.size());
}

void CommonStep::step(std::uint64_t n, Wanted wanted) {
  fill_request(request_, n, model_.dt, wanted);
  round_trip_.run(request_, [this] { book(false); });  // the step before, while they compute this one
  unbooked_ = true;
  if (wanted.energies) book(true);
}

void CommonStep::book(bool with_energies) {
  if (!unbooked_) return;
  unbooked_ = false;
  if (model_.constraint) {
    for (Participant& participant : model_.participants) correct_velocities(participant);
    model_.constraint->read(model_.participants, Part::kCoarse, &Participant::corrected, coarse_);
    model_.constraint->read(model_.participants, Part::kFine, &Participant::corrected, fine_);
    ledger_.book_gap(coarse_, fine_);
  }
  for (std::size_t s = 0; s < model_.participants.size(); ++s) {
    if (with_energies) ledger_.take_energies(s, model_.participants[s]);
    ledger_.close_step(s, model_.participants[s]);
  }
  if (with_energies) ledger_.compare();
}

}  // namespace adit::coupler
