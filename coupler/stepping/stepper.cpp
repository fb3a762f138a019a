#include "coupler/stepping/stepper.hpp"

#include <utility>

#include "coupler/stepping/shared_kick.hpp"

namespace adit::coupler {

namespace {

// All participants take the same step: they predict, the multipliers are solved for, they correct. The
// correction of step n − 1 and the prediction of step n ride in the same message: one round trip a step.
class CommonStep : public TimeScheme {
 public:
  CommonStep(Model& model, CondensedRegions& regions, RoundTrip& round_trip, Ledger& ledger);

  void step(std::uint64_t n, Wanted wanted) override;
  void take_over(const GridMotion& /*motion*/) override {}
  void exchange(state::Archive& archive) override { archive("unbooked", unbooked_); }

 private:
  void book(bool with_energies);

  Model& model_;
  CondensedRegions& regions_;
  RoundTrip& round_trip_;
  Ledger& ledger_;
  wire::Advance request_;
  std::vector<double> coarse_, fine_;  // corrected, one pair for each coupling point
  bool unbooked_ = false;              // the last step is not yet in the ledger
};

CommonStep::CommonStep(Model& model, CondensedRegions& regions, RoundTrip& round_trip, Ledger& ledger)
    : model_(model), regions_(regions), round_trip_(round_trip), ledger_(ledger) {
  for (auto* vector : {&coarse_, &fine_}) vector->resize(model.coupling_points.size());
}

void CommonStep::step(std::uint64_t n, Wanted wanted) {
  fill_request(request_, n, model_.dt, wanted);
  round_trip_.run(request_, [this] { book(false); });  // the step before, while they compute this one
  regions_.move(n);
  unbooked_ = true;
  if (wanted.energies) book(true);
}

void CommonStep::book(bool with_energies) {
  if (!unbooked_) return;
  unbooked_ = false;
  if (model_.constraint) {
    for (Participant& participant : model_.participants)
      if (!participant.waits) correct_velocities(participant);
    model_.constraint->read(model_.participants, Part::kCoarse, &Participant::corrected, coarse_);
    model_.constraint->read(model_.participants, Part::kFine, &Participant::corrected, fine_);
    model_.constraint->close_idle(coarse_, fine_);
    ledger_.book_gap(coarse_, fine_);
  }
  for (std::size_t s = 0; s < model_.participants.size(); ++s) {
    if (model_.participants[s].waits) continue;
    if (with_energies) ledger_.take_energies(s, model_.participants[s]);
    ledger_.close_step(s, model_.participants[s]);
  }
}

}  // namespace

Stepper::Stepper(Model& model)
    : model_(model),
      ledger_(model.participants, rounding_energy(model.participants, model.dt / model.substeps)),
      round_trip_(model, cost_),
      regions_(model, ledger_, cost_) {
  if (model.substeps > 1)
    scheme_ = std::make_unique<SharedKick>(model, regions_, ledger_, cost_);
  else
    scheme_ = std::make_unique<CommonStep>(model, regions_, round_trip_, ledger_);
}

void Stepper::step(std::uint64_t n, Wanted wanted) {
  if (n == 0)  // time starts from rest: the last correction of statics would have no effect
    for (Participant& participant : model_.participants) participant.correction.withhold();
  regions_.prepare();
  // The first step of particles that waited shows what their beginning did to the energy.
  wanted.energies |= std::exchange(just_began_, false);
  if (regions_.nothing_but_they_move())
    regions_.step(n, wanted);
  else
    scheme_->step(n, wanted);
  regions_.look(n, wanted);
  if (wanted.energies) ledger_.compare();
  for (const GridMotion& motion : regions_.begin_near(n)) {
    scheme_->take_over(motion);
    just_began_ = true;
  }
}

void Stepper::relax(std::uint64_t n, const Relaxing& how) {
  fill_request(request_, n, how.dt, {});
  request_.set_relax(true);
  request_.set_stop(how.stop);
  request_.set_stage(how.stage);
  request_.set_local_damping(how.local_damping);
  request_.set_slowing(how.stop ? 0 : how.slowing);
  round_trip_.run(request_);
}

}  // namespace adit::coupler
