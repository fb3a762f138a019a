#include "simplified/column/pore_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::simplified::column {

void PorePressure::follow(double stress) {
  const double begin = reversals_.empty() ? 0 : reversals_.back();
  if ((stress - stress_) * (stress_ - begin) < 0) reversals_.push_back(stress_);
  while (!reversals_.empty()) {
    const std::size_t open = reversals_.size();
    const double last = reversals_.back();
    // The outermost loop closes at the opposite of its beginning.
    const double closure = open > 1 ? reversals_[open - 2] : -last;
    if (std::abs(stress - last) < std::abs(closure - last)) break;
    advance(closure);
    reversals_.resize(open > 1 ? open - 2 : 0);
  }
  advance(stress);
}

double PorePressure::of_half_cycle(double amplitude) const {
  return std::pow(amplitude / resistance_, power_) / 30;
}

void PorePressure::advance(double stress) {
  const auto so_far = [this](double at) {
    return reversals_.empty() ? of_half_cycle(std::abs(at)) / 2
                              : of_half_cycle(std::abs(at - reversals_.back()) / 2);
  };
  damage_ += so_far(stress) - so_far(stress_);
  stress_ = stress;
}

double PorePressure::ratio() const {
  constexpr double kTheta = 0.7;
  return 2 / std::numbers::pi * std::asin(std::pow(std::clamp(damage_, 0.0, 1.0), 1 / (2 * kTheta)));
}

}  // namespace adit::simplified::column
