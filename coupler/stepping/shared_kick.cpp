#include "coupler/stepping/shared_kick.hpp"

#include <algorithm>
#include <numeric>

#include "coupler/exchange/round_trip.hpp"

namespace adit::coupler {

SharedKick::SharedKick(Model& model, CondensedRegions& regions, Ledger& ledger, StepCost& cost)
    : model_(model), regions_(regions), ledger_(ledger), cost_(cost) {
  for (auto* vector : {&w_, &q_, &y_, &v_, &p_, &target_, &lambda_, &lambda_1_, &total_})
    vector->resize(model.coupling_points.size());
}

void SharedKick::step(std::uint64_t n, Wanted wanted) {
  const std::uint64_t m = model_.substeps;
  if (n == 0) return start(wanted);
  for (std::uint64_t k = (n - 1) * m + 1; k <= n * m; ++k) {
    const Wanted at_kick = k == n * m ? wanted : Wanted{};
    if (k % m == m / 2)
      shared_kick(k, n, wanted);
    else
      kick(k, at_kick);
  }
  book();
  if (wanted.energies) take_energies(0.5);
}

void SharedKick::start(Wanted wanted) {
  ask(Role::kContinuum, 0, model_.dt, wanted, &SharedKick::book);
  model_.constraint->read(model_.participants, Part::kCoarse, &Participant::predicted, p_);
  for (std::size_t i = 0; i < w_.size(); ++i) {
    w_[i] = total_[i] = 0;
    y_[i] = -p_[i];
    q_[i] = 2 * p_[i];
  }
  if (regions_.any_wait()) {
    for (Participant& participant : model_.participants)  // what statics left there has no effect
      if (participant.member.role == Role::kContinuum)
        std::ranges::fill(participant.correction.impulses_from(0), 0.0);
    regions_.move(0);
    for (Participant& participant : model_.participants)
      if (participant.member.role == Role::kContinuum) correct_velocities(participant);
  }
  kick(0, wanted);
  book();
  if (wanted.energies) take_energies(1);
}

void SharedKick::take_over(const GridMotion& motion) {
  for (std::size_t i = 2 * motion.begin; i < 2 * motion.end; ++i) {
    w_[i] = motion.velocities[i - 2 * motion.begin];
    q_[i] = motion.kicks[i - 2 * motion.begin];
    y_[i] = w_[i] - q_[i] / 2;
    total_[i] = lambda_[i] = 0;
  }
}

void SharedKick::kick(std::uint64_t k, Wanted wanted) {
  ask(Role::kParticles, k, model_.dt / model_.substeps, wanted, &SharedKick::book);
  const Stopwatch solving(cost_.solve);
  Constraint& constraint = *model_.constraint;
  constraint.read(model_.participants, Part::kFine, &Participant::predicted, v_);
  constraint.solve(w_, v_, lambda_);
  end_kick(lambda_);
}

void SharedKick::shared_kick(std::uint64_t k, std::uint64_t n, Wanted wanted) {
  ask(Role::kParticles, k, model_.dt / model_.substeps, {}, &SharedKick::book);
  Constraint& constraint = *model_.constraint;
  {
    const Stopwatch solving(cost_.solve);
    constraint.read(model_.participants, Part::kFine, &Participant::predicted, v_);
    for (std::size_t i = 0; i < w_.size(); ++i) target_[i] = w_[i] + q_[i];
    constraint.solve(target_, v_, lambda_1_);
    for (std::size_t i = 0; i < w_.size(); ++i) {
      lambda_1_[i] /= 2;
      total_[i] += lambda_1_[i];
      y_[i] = w_[i] + q_[i] / 2;
    }
    constraint.assign(total_, 1, Part::kCoarse, model_.participants);
  }
  ask(Role::kContinuum, n, model_.dt, wanted, &SharedKick::book_grid);
  regions_.move(n);
  const Stopwatch solving(cost_.solve);
  constraint.read(model_.participants, Part::kCoarse, &Participant::predicted, p_);
  for (std::size_t i = 0; i < w_.size(); ++i) {
    q_[i] = p_[i] - y_[i];
    target_[i] = w_[i] + q_[i];
    w_[i] = y_[i] + q_[i] / 2;
  }
  constraint.solve(target_, v_, lambda_);
  for (std::size_t i = 0; i < w_.size(); ++i) {
    total_[i] = 0;
    lambda_[i] /= 2;
    lambda_1_[i] += lambda_[i];
  }
  end_kick(lambda_1_);
}

// Sends the participants of one role to their step and waits for their predictions.
void SharedKick::ask(Role role, std::uint64_t step, double dt, Wanted wanted,
                     void (SharedKick::*meanwhile)()) {
  fill_request(request_, step, dt, wanted);
  const auto asked = [role](const Participant& participant) {
    return participant.member.role == role && !participant.waits;
  };
  for (Participant& participant : model_.participants)
    if (asked(participant)) post_advance(participant, request_);
  (this->*meanwhile)();
  const Stopwatch waiting(cost_.wait);
  for (Participant& participant : model_.participants)
    if (asked(participant)) receive_prediction(participant);
}

void SharedKick::end_kick(const std::vector<double>& multipliers) {
  model_.constraint->assign(multipliers, 1, Part::kFine, model_.participants);
  unbooked_ = true;
}

// Gives the grid's points the multipliers of the last kick, and the ledger what the particles' correction
// did.
void SharedKick::book() {
  if (!unbooked_) return;
  unbooked_ = false;
  model_.constraint->correct_coarse(lambda_, w_);
  for (std::size_t i = 0; i < total_.size(); ++i) total_[i] += lambda_[i];
  for (std::size_t s = 0; s < model_.participants.size(); ++s) {
    Participant& participant = model_.participants[s];
    if (participant.member.role != Role::kParticles || participant.waits) continue;
    correct_velocities(participant);
    if (participant.prediction().has_energies()) ledger_.take_energies(s, participant);
    ledger_.close_step(s, participant);
  }
  model_.constraint->read(model_.participants, Part::kFine, &Participant::corrected, v_);
  model_.constraint->close_idle(w_, v_);
  ledger_.book_gap(w_, v_);
}

// The same of the grid's window that ends with a shared kick.
void SharedKick::book_grid() {
  model_.constraint->correct_coarse(lambda_1_, y_);
  for (std::size_t s = 0; s < model_.participants.size(); ++s) {
    Participant& participant = model_.participants[s];
    if (participant.member.role != Role::kContinuum) continue;
    correct_velocities(participant);
    ledger_.close_step(s, participant);
  }
}

// The grid's energies, of which it knows only what its own last step made of them.
void SharedKick::take_energies(double share_of_kick) {
  std::ranges::fill(target_, 0.0);
  model_.constraint->solve(q_, target_, lambda_1_);
  for (std::size_t i = 0; i < w_.size(); ++i)
    target_[i] = q_[i] * lambda_1_[i] / 8 - total_[i] * (y_[i] + q_[i] / 2 + w_[i]) / 2 +
                 share_of_kick * lambda_[i] * w_[i];
  for (std::size_t s = 0; s < model_.participants.size(); ++s) {
    const Participant& participant = model_.participants[s];
    if (participant.member.role != Role::kContinuum) continue;
    double added = 0;
    for (const Segment& segment : participant.segments) {
      const auto first = target_.begin() + 2 * static_cast<std::ptrdiff_t>(segment.global);
      added = std::accumulate(first, first + 2 * static_cast<std::ptrdiff_t>(segment.count), added);
    }
    ledger_.take_energies(s, participant, added);
  }
}

}  // namespace adit::coupler
