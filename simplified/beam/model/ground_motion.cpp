#include "simplified/beam/model/ground_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "protocol/errors.hpp"

namespace adit::simplified::beam {
namespace {

using Series = std::vector<std::vector<double>>;  // by station, step

std::size_t check(const StationMotions& motions) {
  if (!(motions.dt > 0))
    throw protocol::UserError("dt", fmt::format("the step must be positive, got {:g} s", motions.dt));
  if (motions.chainages.empty()) throw protocol::UserError("chainages", "no station: give at least one");
  for (std::size_t i = 1; i < motions.chainages.size(); ++i)
    if (!(motions.chainages[i] > motions.chainages[i - 1]))
      throw protocol::UserError(fmt::format("chainages[{}]", i), "the chainages of stations must increase");
  std::size_t steps = 0;
  for (const auto* kind : {&motions.displacement, &motions.velocity})
    for (const Series& series : *kind) {
      if (series.empty()) continue;
      if (series.size() != motions.chainages.size())
        throw protocol::UserError("displacement", fmt::format("{} motions for {} stations: give one for each",
                                                              series.size(), motions.chainages.size()));
      for (const auto& station : series) {
        if (steps == 0) steps = station.size();
        if (station.size() != steps || steps < 2)
          throw protocol::UserError("displacement",
                                    fmt::format("one motion has {} steps and another {}: all need the same "
                                                "number, two or more",
                                                station.size(), steps));
      }
    }
  return steps;
}

struct Interpolation {
  std::size_t first, second;
  double fraction;  // weight of the second value
};

Interpolation between_stations(const std::vector<double>& chainages, double x) {
  const std::size_t above = std::upper_bound(chainages.begin(), chainages.end(), x) - chainages.begin();
  if (above == 0) return {0, 0, 0};
  if (above == chainages.size()) return {above - 1, above - 1, 0};
  return {above - 1, above, (x - chainages[above - 1]) / (chainages[above] - chainages[above - 1])};
}

void fill(const Series& series, std::span<const Interpolation> places, Interpolation moment,
          std::vector<double>& values) {
  if (series.empty()) return std::fill(values.begin(), values.end(), 0.0);
  const auto at = [&](std::size_t station) {
    return std::lerp(series[station][moment.first], series[station][moment.second], moment.fraction);
  };
  for (std::size_t p = 0; p < places.size(); ++p)
    values[p] = std::lerp(at(places[p].first), at(places[p].second), places[p].fraction);
}

Interpolation between_steps(double dt, std::size_t steps, double time) {
  const double last = static_cast<double>(steps - 1), position = time / dt;
  // The time is a multiple of the run's step and may exceed the end of the motion by rounding errors.
  if (position > last * (1 + 1e-9))
    throw protocol::UserError("displacement",
                              fmt::format("the ground motion ends at {:g} s, but {:g} s is asked: give a "
                                          "longer motion or a shorter run",
                                          last * dt, time));
  const double step = std::clamp(std::floor(position), 0.0, last - 1);
  return {static_cast<std::size_t>(step), static_cast<std::size_t>(step) + 1, std::min(position - step, 1.0)};
}

}  // namespace

GroundMotion interpolated(StationMotions motions) {
  const std::size_t steps = check(motions);
  if (steps == 0) return still();
  // A std::function copies what it holds, so the motions, which may be large, are shared by the copies.
  auto shared = std::make_shared<const StationMotions>(std::move(motions));
  std::vector<Interpolation> places;  // one for each point, found in the first call
  return [shared, steps, places](double time, std::span<const double> chainages, GroundState& state) mutable {
    if (places.size() != chainages.size()) {
      places.clear();
      for (const double x : chainages) places.push_back(between_stations(shared->chainages, x));
    }
    const Interpolation moment = between_steps(shared->dt, steps, time);
    for (int d = 0; d < 3; ++d) {
      fill(shared->displacement[d], places, moment, state.displacement[d]);
      fill(shared->velocity[d], places, moment, state.velocity[d]);
    }
  };
}

GroundMotion still() {
  return [](double, std::span<const double>, GroundState& state) {
    for (auto* kind : {&state.displacement, &state.velocity})
      for (auto& values : *kind) std::fill(values.begin(), values.end(), 0.0);
  };
}

}  // namespace adit::simplified::beam
