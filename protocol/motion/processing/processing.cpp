#include "protocol/motion/processing/processing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/motion/measures.hpp"

namespace adit::motion {
namespace {

using protocol::UserError;

constexpr double kMostSteps = 1e8;

void require_length(double value, std::string_view what) {
  if (!(value >= 0) || !std::isfinite(value))
    throw UserError("", fmt::format("the {} is {} s; give a time of 0 or more", what, value));
}

std::ptrdiff_t steps(double time, double dt) {
  if (time / dt > kMostSteps)
    throw UserError("", fmt::format("{:.6g} s are more than {:.0e} steps of {:.6g} s; give a shorter time",
                                    time, kMostSteps, dt));
  return std::llround(time / dt);
}

}  // namespace

Motion cut(const Motion& motion, double begin, double end) {
  require_length(begin, "begin of the cut");
  if (!(end > begin))
    throw UserError(
        "", fmt::format("the cut ends at {} s and begins at {} s; give an end after its begin", end, begin));
  require_duration(motion, end, "the motion to cut");
  const auto values = motion.acceleration.begin();
  const auto last = std::min(steps(end, motion.dt), std::ssize(motion.acceleration) - 1);
  return {motion.dt, {values + steps(begin, motion.dt), values + last + 1}};
}

Motion beginning(const Motion& motion, double end) {
  check(motion);
  const double kept = std::ceil(end / motion.dt * (1 - 1e-12)) + 1;
  Motion result = motion;
  if (kept < static_cast<double>(result.acceleration.size()))
    result.acceleration.resize(static_cast<std::size_t>(std::max(kept, 1.0)));
  return result;
}

Motion lasting(const Motion& motion, double end) {
  Motion result = beginning(motion, end);
  const double values = std::ceil(end / motion.dt * (1 - 1e-12)) + 1;
  if (values > kMostSteps)
    throw UserError("", "the motion would have more than 1e8 values; give a longer step");
  if (values > static_cast<double>(result.acceleration.size()))
    result.acceleration.resize(static_cast<std::size_t>(values));
  return result;
}

Motion padded(const Motion& motion, double before, double after) {
  check(motion);
  require_length(before, "time to pad before the motion");
  require_length(after, "time to pad after the motion");
  Motion longer = motion;
  auto& a = longer.acceleration;
  a.insert(a.begin(), static_cast<std::size_t>(steps(before, motion.dt)), 0.0);
  a.insert(a.end(), static_cast<std::size_t>(steps(after, motion.dt)), 0.0);
  return longer;
}

Motion tapered(const Motion& motion, double begin, double end) {
  check(motion);
  require_length(begin, "taper at the begin");
  require_length(end, "taper at the end");
  if (begin + end > motion.duration() * (1 + 1e-9))
    throw UserError(
        "", fmt::format("tapers of {:.6g} s and {:.6g} s overlap in a motion of {:.6g} s; shorten them",
                        begin, end, motion.duration()));
  const auto weight = [](double time, double length) {
    return time < length ? (1 - std::cos(std::numbers::pi * time / length)) / 2 : 1.0;
  };
  Motion result = motion;
  auto& a = result.acceleration;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double from_begin = static_cast<double>(i) * motion.dt;
    const double to_end = static_cast<double>(a.size() - 1 - i) * motion.dt;
    a[i] *= weight(from_begin, begin) * weight(to_end, end);
  }
  return result;
}

Motion scaled(const Motion& motion, double factor) {
  check(motion);
  Motion result = motion;
  for (double& a : result.acceleration) a *= factor;
  check(result);
  return result;
}

Motion scaled_to_peak(const Motion& motion, double peak) {
  return scaled_to_peak(motion, peak, motion);
}

Motion scaled_to_peak(const Motion& motion, double peak, const Motion& curve) {
  require_positive(peak, "peak acceleration to scale to");
  const double found = peaks(curve).acceleration;
  if (found == 0) throw UserError("", "the motion is zero throughout; it cannot be scaled to a peak");
  return scaled(motion, peak / found);
}

}  // namespace adit::motion
