#include "coupler/bridging/solves/split.hpp"

#include <cmath>
#include <limits>

namespace adit::coupler {
namespace {

constexpr double kRegularization = 1e-12;  // ε

// E = ε diag(Nᵀ m N). A coarse point that belongs to no coupling point is left out.
std::vector<double> regularization(const Interpolation& coarse, std::span<const double> fine_masses) {
  std::vector<double> diagonal(2 * coarse.own_points());
  for (std::size_t k = 0; k < coarse.coupling_points(); ++k)
    for (std::size_t e = 0; e < coarse.columns(k).size(); ++e)
      for (const std::size_t direction : {0, 1}) {
        const double value = coarse.values(k)[e];
        diagonal[2 * coarse.columns(k)[e] + direction] +=
            kRegularization * value * fine_masses[2 * k + direction] * value;
      }
  for (double& entry : diagonal)
    // An infinite entry leaves the point out (coarse_mass.hpp); a zero would make the matrix singular.
    if (entry == 0) entry = std::numeric_limits<double>::infinity();
  return diagonal;
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

}  // namespace

double default_decay_rate(double wave_speed, double width) {
  // The fine motion on its way through the overlap decays by exp(-25/4): the mean of across³ is 1/4.
  constexpr double kDecayOnTheWay = 25;
  return kDecayOnTheWay * wave_speed / width;
}

std::vector<double> decay_per_step(std::span<const double> across, double rate, double dt) {
  std::vector<double> shares;
  shares.reserve(across.size());
  // expm1, because 1 − exp(−x) loses all digits for the small x of short time steps.
  for (const double place : across) shares.push_back(-std::expm1(-rate * place * place * place * dt));
  return shares;
}

SplitSolve::SplitSolve(const Interpolation& coarse, std::span<const double> fine_masses,
                       std::span<const double> decay)
    : coarse_(coarse),
      fine_masses_(fine_masses.begin(), fine_masses.end()),
      decay_(decay.begin(), decay.end()),
      fine_only_(coarse, fine_masses, regularization(coarse, fine_masses)),
      both_(coarse, fine_masses, sum(masses_of(coarse), regularization(coarse, fine_masses))),
      carried_(2 * coarse.own_points()),
      shift_(carried_.size()),
      correction_(carried_.size()),
      decayed_(fine_masses.size()),
      momentum_(fine_masses.size()) {}

void SplitSolve::gather_momentum(std::span<const double> velocities, std::span<double> own) {
  for (std::size_t i = 0; i < momentum_.size(); ++i) momentum_[i] = fine_masses_[i] * velocities[i];
  coarse_.gather(momentum_, own);
}

void SplitSolve::solve(std::span<const double> coarse_velocities, std::span<const double> fine_velocities,
                       std::span<double> multipliers) {
  // c = G⁻¹ Nᵀ m v* and w = D (v* − N c)
  gather_momentum(fine_velocities, carried_);
  fine_only_.solve(carried_);
  coarse_.interpolate(carried_, decayed_);
  for (std::size_t i = 0; i < decayed_.size(); ++i)
    decayed_[i] = decay_[i / 2] * (fine_velocities[i] - decayed_[i]);

  // b = Nᵀ m g, then G z = b + Nᵀ m w and (M + G) y = b
  for (std::size_t i = 0; i < multipliers.size(); ++i)
    multipliers[i] = coarse_velocities[i] - fine_velocities[i];
  gather_momentum(multipliers, correction_);
  gather_momentum(decayed_, shift_);
  for (std::size_t j = 0; j < shift_.size(); ++j) shift_[j] += correction_[j];
  fine_only_.solve(shift_);
  both_.solve(correction_);

  // λ = m (N (z − y) − w)
  for (std::size_t j = 0; j < shift_.size(); ++j) shift_[j] -= correction_[j];
  coarse_.interpolate(shift_, multipliers);
  for (std::size_t i = 0; i < multipliers.size(); ++i)
    multipliers[i] = fine_masses_[i] * (multipliers[i] - decayed_[i]);
}

SolveCost SplitSolve::cost() const {
  const SolveCost a = fine_only_.cost(), b = both_.cost();
  return {.factor_seconds = a.factor_seconds + b.factor_seconds,
          .factor_bytes = a.factor_bytes + b.factor_bytes,
          .unknowns = a.unknowns + b.unknowns};
}

}  // namespace adit::coupler
