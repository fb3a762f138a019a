#include "protocol/motion/excitation/ground_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/motion/errors_at.hpp"
#include "protocol/motion/excitation/cut_notes.hpp"
#include "protocol/motion/processing/filter.hpp"
#include "protocol/motion/processing/part.hpp"
#include "protocol/motion/records/records.hpp"
#include "protocol/motion/synthesis/synthetic.hpp"

namespace adit::motion {
namespace {

using protocol::UserError;
using Source = scene::GroundMotion;

// Steps in one of a record, for solvers that take straight lines between values.
constexpr int kPartsOfARecord = 8;

// A pulse of this many widths is below 1e-6 of its peak.
constexpr double kRickerWidths = 4.3, kGaborWidths = 3.8;

Motion recorded(const scene::GroundMotion& scene, const std::string& path, double duration) {
  return errors_at(path + ".file.path", [&] {
    Motion record = parse_motion(scene.file().path(), scene.file().content());
    const std::string name = "the motion " + scene.file().path();
    if (!std::isfinite(scene.until()))
      require_duration(record, scene.from() + duration, name);
    else
      require_duration(record, scene.until(), name);
    return record;
  });
}

// When the whole motion has ended, which the run may cut [s].
double natural_end(const scene::GroundMotion& scene) {
  switch (scene.source_case()) {
    case Source::kRicker:
      return scene.ricker().time() + kRickerWidths / (std::numbers::pi * scene.ricker().frequency());
    case Source::kSine:
      return scene.sine().end();
    case Source::kGabor:
      return scene.gabor().time() +
             kGaborWidths * scene.gabor().width() / (2 * std::numbers::pi * scene.gabor().frequency());
    case Source::kSynthetic:
    case Source::kFile:
    case Source::SOURCE_NOT_SET:
      break;
  }
  return 0;
}

TargetSpectrum target(const scene::SyntheticMotion& synthetic) {
  if (synthetic.spectrum() == scene::SyntheticMotion::EC8_TYPE_1)
    return ec8_type1(1, static_cast<GroundType>(synthetic.ground()));
  return gb18306(1, synthetic.corner_period());
}

constexpr double kShortestPeriod = 0.1, kLongestPeriod = 4;  // of a synthetic motion [s]
constexpr double kLongestPeriods = 3;                        // of them in a synthetic motion, at least

// The shaking grows over the first 15 % of the duration, and decays from its middle on to exp(-3) = 1/20 at
// the end.
Motion synthetic(const scene::SyntheticMotion& scene, const Sampling& sampling) {
  return synthesize({.target = target(scene),
                     .shortest_period = std::max(kShortestPeriod, 4 * sampling.dt),
                     .longest_period = std::min(kLongestPeriod, sampling.duration / kLongestPeriods),
                     .dt = sampling.dt,
                     .duration = sampling.duration,
                     .envelope = {.rise = 0.15 * sampling.duration,
                                  .decay = 0.5 * sampling.duration,
                                  .rate = 6 / sampling.duration},
                     .seed = scene.seed()})
      .motion;
}

// A run too short for any period is a trial: it gets the beginning of a motion of all periods.
double synthetic_duration(const scene::GroundMotion& scene, const Sampling& run) {
  if (std::isfinite(scene.until())) return scene.until();
  const double used = scene.from() + run.duration;
  const double shortest = std::max(kShortestPeriod, 4 * run.dt);
  return used > kLongestPeriods * shortest ? used : kLongestPeriods * std::max(kLongestPeriod, 2 * shortest);
}

// How long a motion is that is made by a formula: one that outlasts the run is made whole.
double whole_duration(const scene::GroundMotion& scene, const Sampling& sampling) {
  if (scene.has_synthetic()) return synthetic_duration(scene, sampling);
  const double used = scene.from() + sampling.duration;
  const double end = natural_end(scene);
  return end > used ? sampling.dt * std::ceil(end / sampling.dt) : used;
}

// The motion before processing. Pulses have a peak of 1 m/s^2, which the `peak` of the scene scales.
Motion raw_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& run) {
  const Sampling sampling{run.dt, whole_duration(scene, run)};
  switch (scene.source_case()) {
    case Source::kFile:
      return recorded(scene, path, run.duration);
    case Source::kRicker:
      return ricker(1, scene.ricker().frequency(), scene.ricker().time(), sampling);
    case Source::kSine:
      return sine(1, scene.sine().frequency(), scene.sine().end(), sampling);
    case Source::kGabor:
      return gabor(1, scene.gabor().frequency(), scene.gabor().width(), scene.gabor().phase(),
                   scene.gabor().time(), sampling);
    case Source::kSynthetic:
      return synthetic(scene.synthetic(), sampling);
    case Source::SOURCE_NOT_SET:
      break;
  }
  throw UserError(path, "has no motion; give one of file, ricker, sine, gabor, synthetic");
}

// The longest period of a synthetic motion follows from its duration, which is that of the run unless `until`
// says otherwise: a shorter run has another motion.
void note_synthetic(const scene::GroundMotion& scene, const Sampling& run, UsedMotion& used) {
  if (!scene.has_synthetic() || std::isfinite(scene.until())) return;
  const double duration = synthetic_duration(scene, run), all = kLongestPeriods * kLongestPeriod;
  if (duration > scene.from() + run.duration)
    used.notes.push_back(
        fmt::format("the run of {:g} s is too short for a synthetic motion, and gets the beginning of one of "
                    "{:g} s; give `until` to choose of which",
                    run.duration, duration));
  else if (duration < all)
    used.notes.push_back(fmt::format(
        "the synthetic motion lasts as long as the run, so that its longest period is {:.3g} s "
        "instead of {:g} s; give an `until` of {:g} s or more, of which a shorter run is then the "
        "beginning",
        duration / kLongestPeriods, kLongestPeriod, all));
}

Motion filtered(const scene::GroundMotion& scene, Motion motion) {
  constexpr int kOrder = 4;
  if (scene.has_low_corner()) motion = high_pass(motion, scene.low_corner(), kOrder, Phase::kZero);
  if (scene.has_high_corner()) motion = low_pass(motion, scene.high_corner(), kOrder, Phase::kZero);
  return motion;
}

Motion whole_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& sampling) {
  Motion motion = raw_motion(scene, path, sampling);
  if (scene.taper() > 0) motion = tapered(motion, scene.taper(), scene.taper());
  motion = filtered(scene, std::move(motion));
  if (scene.baseline()) motion = baseline_corrected(motion);
  return scene.has_peak() ? scaled_to_peak(motion, scene.peak()) : motion;
}

// A record at the steps of a solver. It ends as before, although the kernel spreads a little beyond its ends.
Motion at_step(const Motion& record, double dt) {
  const Course course = integrate(record);
  Motion motion = resampled(record, dt, Interpolation::kBandLimited);
  if (motion.acceleration.size() < 4) return motion;
  return ended_with(motion, course.velocity.back(), course.displacement.back());
}

double natural_step(const scene::GroundMotion& scene, const std::string& path) {
  constexpr double kPerPeriod = 200, kSynthetic = 0.005;
  const auto of_period = [&](double frequency) {
    require_positive(frequency, "frequency of the motion");
    return 1 / (kPerPeriod * frequency);
  };
  return errors_at(scene.has_file() ? path + ".file.path" : path, [&] {
    switch (scene.source_case()) {
      case Source::kFile:
        return parse_motion(scene.file().path(), scene.file().content()).dt;
      case Source::kRicker:
        return of_period(scene.ricker().frequency());
      case Source::kSine:
        return of_period(scene.sine().frequency());
      case Source::kGabor:
        return of_period(scene.gabor().frequency());
      case Source::kSynthetic:
      case Source::SOURCE_NOT_SET:
        break;
    }
    return kSynthetic;
  });
}

}  // namespace

Motion UsedMotion::acting(const Motion& other) const {
  return beginning(interpolation == Interpolation::kBandLimited ? refined(other, kPartsOfARecord) : other,
                   duration);
}

UsedMotion ground_motion(const scene::GroundMotion& scene, const std::string& path,
                         const Sampling& sampling) {
  return errors_at(path, [&] {
    const Motion whole = whole_motion(scene, path, sampling);
    UsedMotion used{.motion = part(whole, scene.from(), scene.until()),
                    .duration = sampling.duration,
                    .place = place_at_begin(whole, scene.from(), scene.until()),
                    .notes = notes_on_cut(whole, {scene.from(), scene.until(), sampling.duration})};
    if (scene.has_file()) {
      used.interpolation = Interpolation::kBandLimited;
      if (used.motion.dt != sampling.dt) used.motion = at_step(used.motion, sampling.dt);
    }
    const double rest = sampling.duration - used.motion.duration();
    note_synthetic(scene, sampling, used);
    if (rest > 0 && std::isfinite(scene.until())) used.motion = padded(used.motion, 0, rest + used.motion.dt);
    return used;
  });
}

UsedMotion ground_motion(const scene::GroundMotion& scene, const std::string& path, double duration) {
  const double step = natural_step(scene, path);
  const bool recorded = scene.source_case() == Source::kFile;
  return ground_motion(scene, path,
                       {.dt = step, .duration = recorded ? duration : step * std::ceil(duration / step)});
}

}  // namespace adit::motion
