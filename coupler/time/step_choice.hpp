// A time step that fits the times for which the scene asks.
#pragma once

#include <cstdint>
#include <span>

namespace adit::coupler {

struct Steps {
  double dt;            // [s]
  std::uint64_t count;  // the last one ends on the duration, or less than a step after it
};

// Equal steps of at most `limit` [s] that end on the duration.
Steps equal_steps(double duration, double limit);

// Steps of this length up to the duration, or less than a step after it.
Steps steps_of(double dt, double duration);

// Steps of at most `limit` [s], a whole number of them in `interval` [s], which is not below `limit`. Among
// the numbers up to a tenth more than needed, the least is taken with which a step ends on the duration and
// on most of `times` [s].
Steps dividing_steps(double duration, double limit, double interval, std::span<const double> times);

// Whether `time` is a whole number of steps, to a millionth of one.
bool on_step(double time, double dt);

}  // namespace adit::coupler
