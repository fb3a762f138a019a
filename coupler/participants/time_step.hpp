#pragma once

#include <cstdint>
#include <span>

#include "coupler/participants/set_up.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// The longest time between two samples [s] that resolves the shortest period.
double sampling_interval(const scene::Spectra& spectra);

// `history_interval`; where absent, a five-hundredth of the duration, or what the spectra need if that is
// less [s].
double row_interval(const scene::Scene& scene);

// A time step that fits the times for which the scene asks.
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

// Sets the model's step, its substeps and their number, so that rows of histories.csv fall on steps and the
// last step ends on the duration, or less than a step after it where no step divides both. Adds a note where
// rows cost many steps. Throws protocol::UserError for a step above the critical
// one, and for substeps that the model cannot take.
void choose_time_step(Model& model);

// The step of a run that goes on [s], for the duration that it has now. Adds a note where a new run would
// take another one, after choose_time_step.
void keep_time_step(Model& model, double dt);

// Afterwards: says where the duration and the share of the critical step are not those stated.
void compare_time_step(Model& model);

// The largest stable step of statics in which all participants may move [s].
double critical_static_step(const Model& model);

// Statics: gives every participant a step of its own, this share of its critical one in statics, by its step
// ratio, and returns the model's [s], the smallest. The time of statics means nothing, so that each part may
// come to rest at its own pace: the same as one clock with masses that give all parts one critical step.
// Without `own_steps` all take the smallest.
double choose_static_steps(Model& model, double share, bool own_steps);

}  // namespace adit::coupler
