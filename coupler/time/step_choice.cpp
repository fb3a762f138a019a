#include "coupler/time/step_choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace adit::coupler {
namespace {

constexpr double kSameStep = 1e-6;       // times this close count as one [steps]
constexpr double kRounding = 1 - 1e-12;  // so that 0.3 s in steps of 0.1 s are three steps
constexpr double kMoreSteps = 1.1;
constexpr double kMostTried = 1e5;  // a participant may name any critical step

// Whether the duration ends on a step, and how many of the times.
std::pair<bool, std::ptrdiff_t> fit(double dt, double duration, std::span<const double> times) {
  return {on_step(duration, dt), std::ranges::count_if(times, [dt](double t) { return on_step(t, dt); })};
}

}  // namespace

bool on_step(double time, double dt) {
  return std::abs(time / dt - std::round(time / dt)) <= kSameStep;
}

Steps equal_steps(double duration, double limit) {
  const double count = std::max(1.0, std::ceil(duration / limit * kRounding));
  return {duration / count, static_cast<std::uint64_t>(count)};
}

Steps steps_of(double dt, double duration) {
  const double count = on_step(duration, dt) ? std::round(duration / dt) : std::ceil(duration / dt);
  return {dt, static_cast<std::uint64_t>(std::max(1.0, count))};
}

Steps dividing_steps(double duration, double limit, double interval, std::span<const double> times) {
  const double fewest = std::ceil(interval / limit * kRounding);
  const double most = std::min(kMoreSteps * fewest, fewest + kMostTried);
  double best = fewest;
  for (double k = fewest + 1; k <= most; ++k)
    if (fit(interval / k, duration, times) > fit(interval / best, duration, times)) best = k;
  return steps_of(interval / best, duration);
}

}  // namespace adit::coupler
