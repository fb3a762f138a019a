#include "protocol/motion/velocity_history.hpp"

#include <utility>

namespace adit::motion {

VelocityHistory::VelocityHistory(Motion motion)
    : motion_(std::move(motion)), velocity_(integrate(motion_).velocity) {}

double VelocityHistory::operator()(double t) const {
  if (t <= 0) return 0;
  const auto& a = motion_.acceleration;
  const double steps = t / motion_.dt;
  if (steps >= static_cast<double>(a.size() - 1)) return velocity_.back();
  const auto i = static_cast<std::size_t>(steps);
  const double share = steps - static_cast<double>(i);
  return velocity_[i] + motion_.dt * share * (a[i] + share / 2 * (a[i + 1] - a[i]));
}

}  // namespace adit::motion
