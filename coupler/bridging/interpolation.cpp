#include "coupler/bridging/interpolation.hpp"

#include <utility>

namespace adit::coupler {

Interpolation::Interpolation(std::vector<std::uint32_t> row_starts, std::vector<std::uint32_t> columns,
                             std::vector<double> values, std::vector<double> inverse_masses,
                             std::vector<double> scaled_inverse_masses)
    : SparseRows(std::move(row_starts), std::move(columns), std::move(values)),
      inverse_masses_(std::move(inverse_masses)),
      of_time_(inverse_masses_),
      of_scaled_statics_(std::move(scaled_inverse_masses)) {}

void Interpolation::take_masses_of(MassesOf masses) {
  if (of_scaled_statics_.empty()) return;
  inverse_masses_ = masses == MassesOf::kScaledStatics ? of_scaled_statics_ : of_time_;
  if (masses != MassesOf::kStatics) return;
  for (std::size_t i = 0; i < inverse_masses_.size(); ++i)
    if (of_scaled_statics_[i] == 0) inverse_masses_[i] = 0;
}

void Interpolation::divide_by_mass(std::span<double> own) const {
  for (std::size_t i = 0; i < inverse_masses_.size(); ++i) own[i] *= inverse_masses_[i];
}

}  // namespace adit::coupler
