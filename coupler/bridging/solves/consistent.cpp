#include "coupler/bridging/solves/consistent.hpp"

namespace adit::coupler {

ConsistentSolve::ConsistentSolve(const Interpolation& coarse, std::span<const double> fine_masses)
    : coarse_(coarse),
      fine_masses_(fine_masses.begin(), fine_masses.end()),
      masses_(coarse, fine_masses, masses_of(coarse)),
      correction_(2 * coarse.own_points()),
      gap_(fine_masses.size()) {}

void ConsistentSolve::solve(std::span<const double> coarse_velocities,
                            std::span<const double> fine_velocities, std::span<double> multipliers) {
  // Until the last line, `multipliers` holds intermediate vectors: m g, then N y.
  for (std::size_t i = 0; i < gap_.size(); ++i) {
    gap_[i] = coarse_velocities[i] - fine_velocities[i];
    multipliers[i] = fine_masses_[i] * gap_[i];
  }
  coarse_.gather(multipliers, correction_);
  masses_.solve(correction_);
  coarse_.interpolate(correction_, multipliers);
  for (std::size_t i = 0; i < gap_.size(); ++i) multipliers[i] = fine_masses_[i] * (gap_[i] - multipliers[i]);
}

}  // namespace adit::coupler
