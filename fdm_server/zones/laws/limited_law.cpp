#include "fdm_server/zones/laws/limited_law.hpp"

#include <algorithm>

namespace adit::fdm {
namespace {

struct Stresses {
  alignas(64) BatchValues mean, across;
  PointValues difference, shear;
};

void copy(const StressView& from, std::uint32_t count, Stresses& to) {
  std::copy_n(from.mean, count, to.mean.begin());
  std::copy_n(from.across, count, to.across.begin());
  for (std::size_t k = 0; k < 4; ++k) {
    std::copy_n(from.difference[k], count, to.difference[k].begin());
    std::copy_n(from.shear[k], count, to.shear[k].begin());
  }
}

void copy(const Stresses& from, std::uint32_t count, const StressView& to) {
  std::copy_n(from.mean.begin(), count, to.mean);
  std::copy_n(from.across.begin(), count, to.across);
  for (std::size_t k = 0; k < 4; ++k) {
    std::copy_n(from.difference[k].begin(), count, to.difference[k]);
    std::copy_n(from.shear[k].begin(), count, to.shear[k]);
  }
}

// -C^-1 (s* - s), and its part across the plane.
void find_lost(const Elasticity& e, std::uint32_t count, const Stresses& trial, const StressView& now,
               StrainBatch& lost, BatchValues& across) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const double p = now.mean[i] - trial.mean[i], zz = now.across[i] - trial.across[i];
    const double pressure = (2 * p + zz) / 3;
    lost.volume[i] = pressure / e.bulk;
    across[i] = pressure / (3 * e.bulk) + (zz - pressure) / (2 * e.shear);
    for (std::size_t k = 0; k < 4; ++k) {
      lost.difference[k][i] = (now.difference[k][i] - trial.difference[k][i]) / e.shear;
      lost.shear[k][i] = (now.shear[k][i] - trial.shear[k][i]) / e.shear;
    }
  }
}

// (s(n+1) - s*)/2 : de + (s* + s(n+1))/2 : de_p, with de_p = -`lost`.
void dissipate(const LawStep& step, const Stresses& trial, const StrainBatch& lost,
               const BatchValues& across) {
  const auto& [mean, zz, difference, shear] = step.stresses;
  for (std::uint32_t i = 0; i < step.count; ++i) {
    const double in_plane = lost.volume[i] - across[i];
    double twice = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double t = trial.difference[k][i], s = trial.shear[k][i];
      twice +=
          step.areas[k][i] *
          ((mean[i] - trial.mean[i]) * step.strains.volume[i] - (mean[i] + trial.mean[i]) * in_plane -
           (zz[i] + trial.across[i]) * across[i] + (difference[k][i] - t) * step.strains.difference[k][i] -
           (difference[k][i] + t) * lost.difference[k][i] + (shear[k][i] - s) * step.strains.shear[k][i] -
           (shear[k][i] + s) * lost.shear[k][i]);
    }
    step.dissipated[i] += twice / 2;
  }
}

}  // namespace

void LimitedLaw::advance(const LawStep& step) {
  chain_->advance(step);
  Stresses trial;
  copy(step.stresses, step.count, trial);
  BatchValues of_elastic_predictor{};
  if (!strength_.return_to_strength(
          {step.first, step.count, step.areas, step.strains, step.stresses, of_elastic_predictor.data()}))
    return;
  StrainBatch lost;
  BatchValues across;
  find_lost(elasticity_, step.count, trial, step.stresses, lost, across);
  copy(trial, step.count, step.stresses);
  chain_->advance({step.first, step.count, step.areas, lost, step.stresses, step.dissipated, across.data()});
  dissipate(step, trial, lost, across);
}

}  // namespace adit::fdm
