#include "protocol/motion/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"

namespace adit::motion {

using protocol::UserError;

double Motion::duration() const {
  return acceleration.empty() ? 0 : dt * static_cast<double>(acceleration.size() - 1);
}

void require_positive(double value, std::string_view what) {
  if (!std::isfinite(value) || value <= 0)
    throw UserError("", fmt::format("the {} is {}; give a value above 0", what, value));
}

void check(const Motion& motion) {
  require_positive(motion.dt, "time step of the motion");
  if (motion.acceleration.empty()) throw UserError("", "the motion has no values; give at least one");
  const auto wrong = std::ranges::find_if_not(motion.acceleration, [](double a) { return std::isfinite(a); });
  if (wrong != motion.acceleration.end())
    throw UserError("", fmt::format("value {} of the motion is {}; a finite acceleration is expected",
                                    wrong - motion.acceleration.begin() + 1, *wrong));
}

void require_duration(const Motion& motion, double duration, std::string_view name) {
  check(motion);
  const double tolerance = 1e-6 * motion.dt;
  if (motion.duration() + tolerance < duration)
    throw UserError("", fmt::format("{} lasts {:.6g} s, but {:.6g} s are asked for; ask for less", name,
                                    motion.duration(), duration));
}

Course integrate(const Motion& motion) {
  check(motion);
  const auto& a = motion.acceleration;
  const double dt = motion.dt;
  Course course{std::vector<double>(a.size()), std::vector<double>(a.size())};
  for (std::size_t i = 1; i < a.size(); ++i) {
    const double v = course.velocity[i - 1];
    course.velocity[i] = v + dt * (a[i - 1] + a[i]) / 2;
    course.displacement[i] = course.displacement[i - 1] + dt * v + dt * dt * (2 * a[i - 1] + a[i]) / 6;
  }
  return course;
}

}  // namespace adit::motion
