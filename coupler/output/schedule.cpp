#include "coupler/output/schedule.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "coupler/participants/time_step.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

// Samples in one period for finding peaks. The sample nearest to the peak of a sine lies at most 1/40 of a
// period from it and is at most 1 - cos(pi/20) = 1.2 % too low.
constexpr double kLooksAPeriod = 20;

}  // namespace

Schedule::Schedule(const Model& model, std::uint64_t stride) : last_(model.steps) {
  const auto& output = model.scene.output();
  const double duration = model.scene.time().duration();
  const auto steps_in = [&](double interval) {
    return static_cast<std::uint64_t>(std::clamp(interval, 1.0, static_cast<double>(model.steps)));
  };
  history_stride_ = steps_in(std::round(row_interval(model.scene) / model.dt));
  // A given interval is kept, and refused by MotionOutputs if it is too long for the spectra.
  if (!output.has_history_interval())
    for (const auto& spectra : output.spectra())
      history_stride_ =
          std::min(history_stride_, steps_in(sampling_interval(spectra) / model.dt * (1 + 1e-9)));
  if (stride > 0) history_stride_ = stride;
  interval_ = static_cast<double>(history_stride_) * model.dt;
  if (output.has_peaks())
    peak_stride_ = output.peaks().has_highest_frequency()
                       ? steps_in(1 / (kLooksAPeriod * output.peaks().highest_frequency() * model.dt))
                       : 1;
  for (const double time : output.field_times()) {
    if (time > duration * (1 + 1e-12))
      throw protocol::UserError(
          "output.field_times",
          fmt::format("asks for {:g} s, after the end of the run at {:g} s", time, duration));
    fields_.insert(static_cast<std::uint64_t>(std::round(time / model.dt)));
  }
  fields_.insert(model.steps);
}

void Schedule::compare(Model& model) const {
  const auto& output = model.scene.output();
  const double dt = model.dt;
  // A longer interval than the run has no second row.
  if (output.has_history_interval() && output.history_interval() < model.scene.time().duration())
    add_where_it_differs(
        model.stated,
        {.key = "output.history_interval",
         .stated = output.history_interval(),
         .acted = interval_,
         .unit = "s",
         .why = model.scene.time().has_dt()
                    ? fmt::format("`time.dt` makes steps of {:g} s; choose a multiple of it", dt)
                    : fmt::format("rows come at whole steps of {:g} s", dt)});
  for (int i = 0; i < output.field_times_size(); ++i)
    add_where_it_differs(model.stated, {.key = fmt::format("output.field_times[{}]", i),
                                        .stated = output.field_times(i),
                                        .acted = std::round(output.field_times(i) / dt) * dt,
                                        .unit = "s",
                                        .why = fmt::format("fields are of whole steps of {:g} s", dt)});
}

std::uint64_t Schedule::row_count() const {
  const auto others = std::ranges::count_if(fields_, [this](std::uint64_t n) { return !is_sample(n); });
  return last_ / history_stride_ + 1 +
         static_cast<std::uint64_t>(others);  // the last step is among the fields
}

}  // namespace adit::coupler
