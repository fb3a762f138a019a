#include "coupler/check/pace.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

#include "coupler/participants/time_step.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSeconds = 1;    // for the whole calibration
constexpr double kWarmUp = 0.25;  // share of it that is not counted: memory is touched for the first time

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Mean seconds of the steps 0, 1, 2 … up to `last` that fit into the time; at least one is done.
double seconds_a_step(double seconds, std::uint64_t last, const std::function<void(std::uint64_t)>& step) {
  std::uint64_t n = 0;
  const auto step_for = [&](double limit) {
    const auto start = Clock::now();
    const std::uint64_t first = n;
    do step(n++);
    while (n <= last && since(start) < limit);
    return since(start) / static_cast<double>(n - first);
  };
  const double cold = step_for(kWarmUp * seconds);
  return n <= last ? step_for((1 - kWarmUp) * seconds) : cold;
}

// By each participant so far [s].
std::vector<double> computed(const Model& model) {
  std::vector<double> seconds;
  for (const Participant& participant : model.participants)
    seconds.push_back(participant.compute_s + participant.hidden_s);
  return seconds;
}

}  // namespace

Pace measure_pace(const Model& model, const Schedule& schedule, Stepper& stepper) {
  Pace pace;
  const bool relaxes = model.scene.has_statics();
  const double dt = std::min(model.dt / model.substeps, critical_static_step(model));
  try {
    if (relaxes)
      pace.relaxing = seconds_a_step(kSeconds / 2, model.scene.statics().max_steps(), [&](std::uint64_t n) {
        stepper.relax(n, {.dt = dt, .local_damping = 0});
      });
    const std::vector<double> before = computed(model);
    std::uint64_t steps = 0;
    pace.step = seconds_a_step(relaxes ? kSeconds / 2 : kSeconds, model.steps, [&](std::uint64_t n) {
      stepper.step(n, schedule.wanted(n));
      ++steps;
    });
    pace.waiting = stepper.regions().any_wait();
    pace.computed = computed(model);
    for (std::size_t s = 0; s < before.size(); ++s)
      pace.computed[s] = (pace.computed[s] - before[s]) / static_cast<double>(steps);
  } catch (const protocol::Unstable& error) {
    pace.unstable = error.what();
  }
  return pace;
}

}  // namespace adit::coupler
