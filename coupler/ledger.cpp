#include "coupler/ledger.hpp"

#include <algorithm>
#include <cmath>

namespace adit::coupler {
namespace {

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

Ledger::Ledger(std::size_t sides, std::size_t coupling_values)
    : energies_(sides),
      multiplier_work_(sides),
      kinetic_correction_(sides),
      previous_(sides, {std::vector<double>(coupling_values), std::vector<double>(coupling_values)}) {}

void Ledger::add_step(std::uint64_t n, const std::vector<Side>& sides, bool with_energies) {
  book_multipliers(n, sides);
  book_residual(sides);
  if (!with_energies) return;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const wire::Energies& e = sides[s].prediction().energies();
    energies_[s] = {.kinetic = e.kinetic() + kinetic_correction_[s],
                    .strain = e.strain(),
                    .released = e.released(),
                    .external_work = e.external_work(),
                    .multiplier_work = multiplier_work_[s]};
  }
  if (n == 0) unexplained_at_start_ = unexplained();
  peak_stored_ = std::max(peak_stored_, stored());
  peak_unexplained_ = std::max(peak_unexplained_, std::abs(unexplained()));
}

void Ledger::book_multipliers(std::uint64_t n, const std::vector<Side>& sides) {
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const Side& side = sides[s];
    Previous& previous = previous_[s];
    if (n == 0) {
      kinetic_correction_[s] =
          -0.5 * (dot(side.impulses, side.predicted) + dot(side.impulses, side.corrected));
    } else {
      const double work = dot(previous.velocities, side.impulses);
      kinetic_correction_[s] = 0.5 * work;
      multiplier_work_[s] += 0.5 * (dot(previous.velocities, previous.impulses) + work);
    }
    std::copy(side.impulses.begin(), side.impulses.end(), previous.impulses.begin());
    std::copy(side.corrected.begin(), side.corrected.end(), previous.velocities.begin());
    if (n == 0)
      for (double& impulse : previous.impulses) impulse *= 2;
  }
}

void Ledger::book_residual(const std::vector<Side>& sides) {
  if (sides.size() < 2) return;
  for (std::size_t i = 0; i < sides[0].corrected.size(); ++i) {
    largest_gap_ = std::max(largest_gap_, std::abs(sides[0].corrected[i] - sides[1].corrected[i]));
    largest_velocity_ = std::max(largest_velocity_, std::abs(sides[0].corrected[i]));
  }
}

double Ledger::stored() const {
  double sum = 0;
  for (const SideEnergies& e : energies_) sum += e.kinetic + e.strain + e.released;
  return sum;
}

double Ledger::unexplained() const {
  double sum = stored() - unexplained_at_start_;
  for (const SideEnergies& e : energies_) sum -= e.external_work;
  return sum;
}

double Ledger::drift() const {
  return peak_stored_ > 0 ? unexplained() / peak_stored_ : 0;
}

double Ledger::max_drift() const {
  return peak_stored_ > 0 ? peak_unexplained_ / peak_stored_ : 0;
}

double Ledger::kept() const {
  const double work = stored() - unexplained();
  return work > 0 ? stored() / work : 1;
}

double Ledger::max_constraint_residual() const {
  return largest_velocity_ > 0 ? largest_gap_ / largest_velocity_ : 0;
}

}  // namespace adit::coupler
