#include "protocol/springs/force_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace adit::protocol {

ForceCurve::ForceCurve(std::vector<double> opening, std::vector<double> force)
    : opening_(std::move(opening)), force_(std::move(force)), datum_(integral(without_force())) {}

std::size_t ForceCurve::segment(double opening) const {
  const auto above = std::upper_bound(opening_.begin() + 1, opening_.end() - 1, opening);
  return static_cast<std::size_t>(above - opening_.begin()) - 1;
}

double ForceCurve::slope_of(std::size_t k) const {
  return (force_[k + 1] - force_[k]) / (opening_[k + 1] - opening_[k]);
}

double ForceCurve::force(double opening) const {
  const std::size_t k = segment(opening);
  return force_[k] + slope_of(k) * (opening - opening_[k]);
}

double ForceCurve::slope(double opening) const {
  return slope_of(segment(opening));
}

double ForceCurve::energy(double opening) const {
  return integral(opening) - datum_;
}

double ForceCurve::integral(double opening) const {
  const std::size_t last = segment(opening);
  double sum = 0;
  for (std::size_t k = 0; k < last; ++k)
    sum += (opening_[k + 1] - opening_[k]) * (force_[k] + force_[k + 1]) / 2;
  return sum + (opening - opening_[last]) * (force_[last] + force(opening)) / 2;
}

double ForceCurve::without_force() const {
  const std::size_t segments = opening_.size() - 1;
  double nearest = std::numeric_limits<double>::infinity();
  const auto offer = [&nearest](double place) {
    if (std::abs(place) < std::abs(nearest)) nearest = place;
  };
  for (std::size_t k = 0; k < segments; ++k) {
    const double begin = k == 0 ? -std::numeric_limits<double>::infinity() : opening_[k];
    const double end = k + 1 == segments ? std::numeric_limits<double>::infinity() : opening_[k + 1];
    if (slope_of(k) == 0) {
      if (force_[k] == 0) offer(std::clamp(0.0, begin, end));
      continue;
    }
    const double zero = opening_[k] - force_[k] / slope_of(k);
    if (zero >= begin && zero <= end) offer(zero);
  }
  return std::isfinite(nearest) ? nearest : 0;
}

double ForceCurve::steepest() const {
  double steepest = 0;
  for (std::size_t k = 0; k + 1 < opening_.size(); ++k) steepest = std::max(steepest, std::abs(slope_of(k)));
  return steepest;
}

}  // namespace adit::protocol
