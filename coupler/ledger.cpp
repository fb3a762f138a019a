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

Ledger::Ledger(const std::vector<Side>& sides, const std::vector<Interface>& interfaces)
    : energies_(sides.size()), multiplier_work_(sides.size()), kinetic_correction_(sides.size()) {
  for (const Side& side : sides)
    previous_.push_back(
        {std::vector<double>(side.impulses.size()), std::vector<double>(side.impulses.size())});
  const auto begin_of = [&](std::size_t side, const Interface& interface) {
    return std::find_if(sides[side].segments.begin(), sides[side].segments.end(),
                        [&](const Segment& segment) { return segment.global == interface.begin; })
        ->begin;
  };
  for (const Interface& interface : interfaces)
    ties_.push_back({interface.coarse, begin_of(interface.coarse, interface), interface.fine,
                     begin_of(interface.fine, interface), interface.end - interface.begin});
}

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
  for (const Tie& tie : ties_) {
    const double* coarse = &sides[tie.coarse].corrected[2 * tie.coarse_begin];
    const double* fine = &sides[tie.fine].corrected[2 * tie.fine_begin];
    for (std::size_t i = 0; i < 2 * tie.count; ++i) {
      largest_gap_ = std::max(largest_gap_, std::abs(coarse[i] - fine[i]));
      largest_velocity_ = std::max(largest_velocity_, std::abs(coarse[i]));
    }
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
