#include "coupler/stepping/stepper.hpp"

#include "coupler/stepping/common_step.hpp"
#include "coupler/stepping/shared_kick.hpp"

namespace adit::coupler {

Stepper::Stepper(Model& model)
    : model_(model),
      ledger_(model.participants, rounding_energy(model.participants, model.dt / model.substeps)),
      round_trip_(model, cost_) {
  if (model.substeps > 1)
    scheme_ = std::make_unique<SharedKick>(model, ledger_, cost_);
  else
    scheme_ = std::make_unique<CommonStep>(model, round_trip_, ledger_);
}

void Stepper::step(std::uint64_t n, Wanted wanted) {
  if (n == 0)  // time starts from rest: the last correction of statics would have no effect
    for (Participant& participant : model_.participants) participant.correction.withhold();
  scheme_->step(n, wanted);
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
