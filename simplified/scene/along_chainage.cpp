#include "simplified/scene/along_chainage.hpp"

#include <algorithm>

namespace adit::simplified {

AlongChainage::AlongChainage(const std::vector<double>& places, const std::vector<double>& chainages)
    : pivots_(places.size()), curvatures_(places.size()) {
  for (std::size_t k = 0; k + 1 < places.size(); ++k) gaps_.push_back(places[k + 1] - places[k]);
  for (std::size_t k = 1; k < gaps_.size(); ++k)
    // The matrix depends on the places only, so it is factored once for all steps.
    pivots_[k] = 1 / (2 * (gaps_[k - 1] + gaps_[k]) - gaps_[k - 1] * gaps_[k - 1] * pivots_[k - 1]);
  for (const double x : chainages) {
    // The search leaves out both ends, so that a chainage beyond them falls into the first or the last gap.
    const auto after = std::upper_bound(places.begin() + 1, places.end() - 1, x);
    const auto k = static_cast<std::size_t>(after - places.begin()) - 1;
    const double b = std::clamp((x - places[k]) / gaps_[k], 0.0, 1.0), a = 1 - b;
    const double square = gaps_[k] * gaps_[k] / 6;
    points_.push_back({k, a, b, square * a * (a * a - 1), square * b * (b * b - 1)});
  }
}

// Continuous slopes require gap_k-1 c_k-1 + 2 (gap_k-1 + gap_k) c_k + gap_k c_k+1 = 6 (slope_k - slope_k-1)
// for the curvatures c, which are zero at the ends. The matrix is tridiagonal and diagonally dominant.
void AlongChainage::find_curvatures(const double* v) {
  const std::size_t last = gaps_.size();
  double before = 0, slope = (v[1] - v[0]) / gaps_[0];
  for (std::size_t k = 1; k < last; ++k) {
    const double next = (v[k + 1] - v[k]) / gaps_[k];
    curvatures_[k] = before = pivots_[k] * (6 * (next - slope) - gaps_[k - 1] * before);
    slope = next;
  }
  for (std::size_t k = last - 1; k > 0; --k) curvatures_[k] -= pivots_[k] * gaps_[k] * curvatures_[k + 1];
}

void AlongChainage::interpolate(const double* values, double* to) {
  find_curvatures(values);
  const double* curvatures = curvatures_.data();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto& [k, a, b, c, d] = points_[i];
    to[i] = a * values[k] + b * values[k + 1] + c * curvatures[k] + d * curvatures[k + 1];
  }
}

void AlongChainage::interpolate_linearly(const double* values, double* to) const {
  for (std::size_t i = 0; i < points_.size(); ++i)
    to[i] = points_[i].a * values[points_[i].before] + points_[i].b * values[points_[i].before + 1];
}

}  // namespace adit::simplified
