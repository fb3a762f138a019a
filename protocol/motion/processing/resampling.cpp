#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/motion/processing/processing.hpp"

namespace adit::motion {
namespace {

constexpr double kCrossings = 32;    // zero crossings on each side of the kernel
constexpr double kKaiser = 9;        // ripple 3e-5 in pass and stop band
constexpr double kSamePlace = 1e-9;  // two times this close count as one [steps]
constexpr double kMostValues = 1e8;

// The low pass at `rate` (<= 1) times the Nyquist frequency, for a time that lies `fraction` of a step after
// a value: weights of the values, beginning weights.size()/2 - 1 values before that one.
std::vector<double> kernel(double fraction, double rate) {
  const int half = static_cast<int>(std::ceil(kCrossings / rate));
  std::vector<double> weights(2 * static_cast<std::size_t>(half));
  double sum = 0;
  for (int k = 0; k < 2 * half; ++k) {
    const double x = rate * (fraction - (k - half + 1));  // in crossings
    const double z = std::numbers::pi * x, share = x / kCrossings;
    const double sinc = z == 0 ? 1 : std::sin(z) / z;
    const double window =
        share * share < 1 ? std::cyl_bessel_i(0.0, kKaiser * std::sqrt(1 - share * share)) : 0.0;
    sum += weights[static_cast<std::size_t>(k)] = sinc * window;
  }
  for (double& weight : weights) weight /= sum;  // so that a constant is kept
  return weights;
}

// Sum of the weights times the values from number `first` on; values beyond the ends are zero.
double weighted(std::span<const double> values, std::ptrdiff_t first, std::span<const double> weights) {
  const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(0, -first);
  const std::ptrdiff_t end = std::min(std::ssize(weights), std::ssize(values) - first);
  double sum = 0;
  for (std::ptrdiff_t k = begin; k < end; ++k)
    sum += weights[static_cast<std::size_t>(k)] * values[static_cast<std::size_t>(first + k)];
  return sum;
}

}  // namespace

Motion resampled(const Motion& motion, double dt, Interpolation interpolation) {
  check(motion);
  require_positive(dt, "time step to resample to");
  const double count = std::floor(motion.duration() / dt + kSamePlace) + 1;
  if (count > kMostValues)
    throw protocol::UserError("",
                              "the time step to resample to gives more than 1e8 values; give a longer one");
  const double ratio = dt / motion.dt, rate = std::min(1.0, 1 / ratio);
  Motion result{dt, std::vector<double>(static_cast<std::size_t>(count))};
  for (std::size_t i = 0; i < result.acceleration.size(); ++i) {
    const double place = static_cast<double>(i) * ratio;
    const double before = std::floor(place + kSamePlace);
    const double fraction = std::max(0.0, place - before);
    const auto first = static_cast<std::ptrdiff_t>(before);
    std::vector<double> weights;
    // A time that coincides with a given value takes that value, so that the step itself is exact.
    if (interpolation == Interpolation::kLinear)
      weights = {1 - fraction, fraction};
    else if (rate == 1 && fraction < kSamePlace)
      weights = {1, 0};
    else
      weights = kernel(fraction, rate);
    result.acceleration[i] = weighted(motion.acceleration, first - std::ssize(weights) / 2 + 1, weights);
  }
  return result;
}

Motion refined(const Motion& motion, int parts) {
  const Course course = integrate(motion);
  const std::size_t steps = motion.acceleration.size() - 1;
  Motion result{motion.dt / parts, std::vector<double>(steps * static_cast<std::size_t>(parts) + 1)};
  for (int part = 0; part < parts; ++part) {
    const std::vector<double> weights =
        part == 0 ? std::vector<double>{1, 0} : kernel(static_cast<double>(part) / parts, 1);
    const std::ptrdiff_t before = std::ssize(weights) / 2 - 1;
    for (std::size_t i = 0; i <= (part == 0 ? steps : steps - 1); ++i)
      result.acceleration[i * static_cast<std::size_t>(parts) + static_cast<std::size_t>(part)] =
          weighted(motion.acceleration, static_cast<std::ptrdiff_t>(i) - before, weights);
  }
  if (result.acceleration.size() < 4) return result;
  return ended_with(result, course.velocity.back(), course.displacement.back());
}

Motion delayed(const Motion& motion, double delay, std::size_t count) {
  check(motion);
  const double place = delay / motion.dt;
  if (!(std::abs(place) < kMostValues))
    throw protocol::UserError(
        "", "a delay of the motion is longer than 1e8 steps; give a larger apparent velocity");
  const double later = std::ceil(place - kSamePlace);
  const double fraction = std::max(0.0, later - place);
  const std::vector<double> weights = fraction < kSamePlace ? std::vector<double>{1, 0} : kernel(fraction, 1);
  const std::ptrdiff_t first = -static_cast<std::ptrdiff_t>(later) - std::ssize(weights) / 2 + 1;
  Motion result{motion.dt, std::vector<double>(count)};
  for (std::size_t i = 0; i < count; ++i)
    result.acceleration[i] = weighted(motion.acceleration, first + static_cast<std::ptrdiff_t>(i), weights);
  return result;
}

}  // namespace adit::motion
