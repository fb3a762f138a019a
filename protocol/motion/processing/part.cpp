#include "protocol/motion/processing/part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/motion/processing/processing.hpp"

namespace adit::motion {
namespace {

using protocol::UserError;

constexpr double kWindow = 1;          // [s]
constexpr double kShareOfPart = 0.25;  // at most
constexpr std::size_t kFewestSteps = 4;

struct Stretch {
  std::size_t begin, end;  // numbers of the first and last value
};

Stretch stretch(const Motion& whole, double from, double until) {
  check(whole);
  const std::size_t last = whole.acceleration.size() - 1;
  if (!(from <= whole.duration()))
    throw UserError("", fmt::format("the part begins at {:g} s, but the motion ends at {:g} s; begin earlier",
                                    from, whole.duration()));
  const auto begin = static_cast<std::size_t>(std::llround(from / whole.dt));
  if (!(until < whole.duration())) return {begin, last};
  return {begin, static_cast<std::size_t>(std::llround(until / whole.dt))};
}

std::size_t window_steps(const Motion& whole, const Stretch& part) {
  const double steps =
      std::min(std::round(kWindow / whole.dt), kShareOfPart * static_cast<double>(part.end - part.begin));
  if (steps < kFewestSteps)
    throw UserError(
        "", fmt::format("the part of the motion has {} values, too few to begin and end at rest; "
                        "give at least {}",
                        part.end - part.begin + 1, static_cast<double>(kFewestSteps) / kShareOfPart + 1));
  return static_cast<std::size_t>(steps);
}

// The first or last `steps` of a part.
struct Ramp {
  std::size_t first;  // value of the whole motion
  std::size_t steps;
  bool rises;
};

// (w v)' at each value of the ramp. Sampling it alone would leave a small velocity, which grows to a
// displacement over the run: the correction makes it `gained` after the ramp.
Motion windowed(const Motion& whole, const Course& course, const Ramp& ramp, double gained) {
  Motion result{whole.dt, std::vector<double>(ramp.steps + 1)};
  const double length = static_cast<double>(ramp.steps) * whole.dt;
  for (std::size_t i = 0; i <= ramp.steps; ++i) {
    const std::size_t risen = ramp.rises ? i : ramp.steps - i, at = ramp.first + i;
    const double angle = std::numbers::pi * static_cast<double>(risen) / static_cast<double>(ramp.steps);
    const double weight = (1 - std::cos(angle)) / 2, slope = std::numbers::pi / 2 * std::sin(angle) / length;
    result.acceleration[i] =
        weight * whole.acceleration[at] + (ramp.rises ? slope : -slope) * course.velocity[at];
  }
  return ended_with(result, gained, integrate(result).displacement.back());
}

}  // namespace

Motion part(const Motion& whole, double from, double until) {
  const Stretch kept = stretch(whole, from, until);
  const bool rises = kept.begin > 0, falls = kept.end + 1 < whole.acceleration.size();
  const auto values = whole.acceleration.begin();
  Motion result{
      whole.dt,
      {values + static_cast<std::ptrdiff_t>(kept.begin), values + static_cast<std::ptrdiff_t>(kept.end) + 1}};
  if (!rises && !falls) return result;
  const Course course = integrate(whole);
  const std::size_t steps = window_steps(whole, kept);
  if (rises)
    std::ranges::copy(
        windowed(whole, course, {kept.begin, steps, true}, course.velocity[kept.begin + steps]).acceleration,
        result.acceleration.begin());
  if (falls)
    std::ranges::copy(
        windowed(whole, course, {kept.end - steps, steps, false}, -course.velocity[kept.end - steps])
            .acceleration,
        result.acceleration.end() - static_cast<std::ptrdiff_t>(steps) - 1);
  return result;
}

double place_at_begin(const Motion& whole, double from, double until) {
  const Stretch kept = stretch(whole, from, until);
  if (kept.begin == 0) return 0;
  const std::size_t steps = window_steps(whole, kept);
  return integrate(whole).displacement[kept.begin + steps] -
         integrate(part(whole, from, until)).displacement[steps];
}

double added_by_window(const Motion& whole, double from, double until) {
  const Stretch kept = stretch(whole, from, until);
  const Motion used = part(whole, from, until);
  double largest = 0;
  for (std::size_t i = 0; i < used.acceleration.size(); ++i)
    largest =
        std::max(largest, std::abs(used.acceleration[i]) - std::abs(whole.acceleration[kept.begin + i]));
  return largest;
}

}  // namespace adit::motion
