#include "coupler/stepping/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "protocol/kernels/sums.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::coupler {
namespace {

// Share of the first energies of all participants below which their sum is one of rounding errors. It is 0
// where a load on the overlap has begun and nothing has moved yet, though one model's part is the negative of
// the other's. Later energies do not count: those of an unstable run grow without bound while their sum
// stays, and the rounding of the sum shows it.
constexpr double kRounded = 1e-6;
constexpr double kStill = 1e-6;  // a speed that means nothing [m/s]

double mass_of(const std::vector<Participant>& participants) {
  double mass = 0;
  for (const Participant& participant : participants) mass += participant.counts.mass();
  return mass;
}

ADIT_VECTOR_CLONES double dot(std::span<const double> a, std::span<const double> b) {
  return protocol::eight_sums(0, a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

ParticipantEnergies energies_of(const wire::Energies& told, double kinetic, double multiplier_work) {
  return {.kinetic = kinetic,
          .strain = told.strain(),
          .released = told.released(),
          .external_work = told.external_work(),
          .multiplier_work = multiplier_work,
          .dissipated = told.dissipated()};
}

}  // namespace

double rounding_energy(const std::vector<Participant>& participants, double dt) {
  double coordinate = 0;
  for (const Participant& participant : participants) {
    const wire::Model& model = participant.model;
    for (const double bound : {model.x_min(), model.x_max(), model.y_min(), model.y_max()})
      coordinate = std::max(coordinate, std::abs(bound));
  }
  const double speed = std::numeric_limits<double>::epsilon() * coordinate / dt;
  return mass_of(participants) * speed * speed / 2;
}

Ledger::Ledger(const std::vector<Participant>& participants, double rounding)
    : rounding_(rounding),
      still_(mass_of(participants) * kStill * kStill / 2),
      energies_(participants.size()),
      accounts_(participants.size()),
      balances_at_start_(participants.size()) {
  for (std::size_t s = 0; s < participants.size(); ++s) {
    accounts_[s].impulses.resize(participants[s].predicted.size());
    accounts_[s].velocities.resize(participants[s].predicted.size());
  }
}

void Ledger::take_energies(std::size_t s, const Participant& participant) {
  const Account& account = accounts_[s];
  const wire::Energies& e = participant.prediction().energies();
  double kinetic = e.kinetic(), work = account.multiplier_work;
  if (account.started) {
    const double power = dot(account.velocities, participant.correction.impulses());
    kinetic += 0.5 * power;
    work += 0.5 * (dot(account.velocities, account.impulses) + power);
  } else {
    kinetic -= 0.5 * (dot(participant.correction.impulses(), participant.predicted) +
                      dot(participant.correction.impulses(), participant.corrected));
  }
  energies_[s] = energies_of(e, kinetic, work);
}

// What the impulses of regions that wait add, which a grid gets whole with its step: as in the other form.
double Ledger::of_nodes(const Account& account, const Participant& participant) {
  const std::size_t begin = 2 * participant.nodes_begin;
  const auto from = [begin](std::span<const double> all) { return all.subspan(begin); };
  const std::span<const double> impulses = from(participant.correction.impulses());
  if (account.started) return 0.5 * dot(from(account.velocities), impulses);
  return -0.5 * (dot(impulses, from(participant.predicted)) + dot(impulses, from(participant.corrected)));
}

// With the impulses p_n that it gets from step n to step n + 1, what a participant tells changes by
// ½ (N v(n−½) + N v(n+½))·p_n. Work counts from the start, so that what is added there, and the impulse that
// is booked as twice a half there, are none.
void Ledger::take_energies(std::size_t s, const Participant& participant, double added) {
  Account& account = accounts_[s];
  added += of_nodes(account, participant);
  if (!account.started) account.added_at_start = added;
  const wire::Energies& e = participant.prediction().energies();
  const double work = account.multiplier_work + 0.5 * dot(account.velocities, account.impulses);
  energies_[s] = energies_of(e, e.kinetic() + added, work + added - account.added_at_start);
}

void Ledger::begin(std::size_t s, const Participant& participant, double multiplier_work) {
  if (!changes_) {
    unexplained_before_ = unexplained();
    for (std::size_t k = 0; k < energies_.size(); ++k) balances_at_start_[k] -= energies_[k].balance();
  }
  changes_ = true;
  Account& account = accounts_[s];
  account.started = true;
  account.multiplier_work = multiplier_work;
  std::ranges::fill(account.impulses, 0.0);
  std::ranges::copy(participant.predicted, account.velocities.begin());
}

void Ledger::compare() {
  double turnover = 0;
  for (std::size_t s = 0; s < energies_.size(); ++s) {
    if (!compared_) balances_at_start_[s] = energies_[s].balance();
    turnover += energies_[s].turnover();
  }
  if (!compared_) unexplained_at_start_ = unexplained();
  compared_ = true;
  if (changes_) {  // what participants tell is counted from other places now
    for (std::size_t s = 0; s < energies_.size(); ++s) balances_at_start_[s] += energies_[s].balance();
    const double change = (unexplained() - unexplained_before_) / std::max(peak_stored_, stored());
    if (std::abs(change) > std::abs(change_)) change_ = change;
    changes_ = false;
  }
  if (first_turnover_ == 0) first_turnover_ = turnover;
  peak_turnover_ = std::max(peak_turnover_, turnover);
  peak_stored_ = std::max(peak_stored_, stored());
  peak_unexplained_ = std::max(peak_unexplained_, std::abs(unexplained()));
}

void Ledger::close_step(std::size_t s, const Participant& participant) {
  Account& account = accounts_[s];
  const std::span<const double> impulses = participant.correction.impulses();
  if (account.started)
    account.multiplier_work +=
        0.5 * (dot(account.velocities, account.impulses) + dot(account.velocities, impulses));
  else
    account.added_at_start +=
        0.5 * (dot(impulses, participant.predicted) + dot(impulses, participant.corrected));
  const double steps = account.started ? 1 : 2;  // half a step has half an impulse
  for (std::size_t i = 0; i < impulses.size(); ++i) account.impulses[i] = steps * impulses[i];
  std::copy(participant.corrected.begin(), participant.corrected.end(), account.velocities.begin());
  account.started = true;
}

void Ledger::book_gap(std::span<const double> coarse, std::span<const double> fine) {
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    largest_gap_ = std::max(largest_gap_, std::abs(coarse[i] - fine[i]));
    largest_velocity_ = std::max(largest_velocity_, std::abs(coarse[i]));
  }
}

double Ledger::stored() const {
  double sum = 0;
  for (const ParticipantEnergies& e : energies_) sum += e.kinetic + e.strain + e.released;
  return sum;
}

double Ledger::unexplained() const {
  double sum = stored() - unexplained_at_start_;
  for (const ParticipantEnergies& e : energies_) sum += e.dissipated - e.external_work;
  return sum;
}

double Ledger::drift() const {
  const double scale = std::max({peak_stored_, rounding_, kRounded * first_turnover_});
  return scale > 0 ? unexplained() / scale : 0;
}

Ledger::Loss Ledger::loss() const {
  double lost = 0, largest = 0;
  Loss loss{0, 0};
  for (std::size_t s = 0; s < balances_at_start_.size(); ++s) {
    const double its = balances_at_start_[s] - energies_[s].balance();
    lost += its;
    if (!(its > largest)) continue;
    largest = its;
    loss.participant = s;
  }
  const double scale = std::max({peak_turnover_, rounding_, still_});
  if (scale > 0) loss.share = lost / scale;
  return loss;
}

double Ledger::max_drift() const {
  return peak_stored_ > 0 ? peak_unexplained_ / peak_stored_ : 0;
}

double Ledger::kept() const {
  const double work = stored() - unexplained();
  return work > 0 ? stored() / work : 1;
}

void Ledger::exchange(state::Archive& archive) {
  archive("energies", std::span(energies_));
  for (Account& account : accounts_) {
    archive("account_started", account.started);
    archive("account_work", account.multiplier_work);
    archive("account_added_at_start", account.added_at_start);
    archive("account_impulses", std::span(account.impulses));
    archive("account_velocities", std::span(account.velocities));
  }
  archive("compared", compared_);
  archive("balances_at_start", std::span(balances_at_start_));
  archive("ledger_unexplained_at_start", unexplained_at_start_);
  archive("ledger_first_turnover", first_turnover_);
  archive("ledger_peak_turnover", peak_turnover_);
  archive("ledger_peak_stored", peak_stored_);
  archive("ledger_peak_unexplained", peak_unexplained_);
  archive("ledger_change", change_);
  archive("ledger_changes", changes_);
  archive("ledger_unexplained_before", unexplained_before_);
  archive("ledger_largest_gap", largest_gap_);
  archive("ledger_largest_velocity", largest_velocity_);
}

double Ledger::max_constraint_residual() const {
  return largest_velocity_ > 0 ? largest_gap_ / largest_velocity_ : 0;
}

}  // namespace adit::coupler
