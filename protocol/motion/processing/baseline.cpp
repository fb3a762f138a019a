#include <Eigen/Dense>

#include "protocol/errors.hpp"
#include "protocol/motion/processing/processing.hpp"

namespace adit::motion {
namespace {

Eigen::Vector2d at_end(const Motion& motion) {
  const Course course = integrate(motion);
  return {course.velocity.back(), course.displacement.back()};
}

// The shape s^power (1 - s) with s = t / duration, at the times of `motion`.
Motion shape(const Motion& motion, int power) {
  Motion shape = motion;
  auto& a = shape.acceleration;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(a.size() - 1);
    a[i] = (power == 1 ? s : s * s) * (1 - s);
  }
  return shape;
}

}  // namespace

// Final velocity and displacement depend linearly on the acceleration, so the factors of two shapes follow
// from two linear equations.
Motion ended_with(const Motion& motion, double velocity, double displacement) {
  check(motion);
  if (motion.acceleration.size() < 4)
    throw protocol::UserError("", "the motion has fewer than 4 values; a baseline cannot be fitted to it");
  const Motion first = shape(motion, 1), second = shape(motion, 2);
  Eigen::Matrix2d ends;
  ends << at_end(first), at_end(second);
  const Eigen::Vector2d c = ends.inverse() * (Eigen::Vector2d(velocity, displacement) - at_end(motion));
  Motion result = motion;
  for (std::size_t i = 0; i < result.acceleration.size(); ++i)
    result.acceleration[i] += c[0] * first.acceleration[i] + c[1] * second.acceleration[i];
  return result;
}

Motion baseline_corrected(const Motion& motion) {
  return ended_with(motion, 0, 0);
}

}  // namespace adit::motion
