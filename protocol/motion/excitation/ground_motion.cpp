#include "protocol/motion/excitation/ground_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/motion/errors_at.hpp"
#include "protocol/motion/excitation/cut_notes.hpp"
#include "protocol/motion/measures.hpp"
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

// A synthetic motion whose end is not stated: five of its longest periods [s].
constexpr double kSyntheticDuration = 20;

Motion record_of(const scene::MotionFile& file) {
  return parse_motion(file.path(), file.content(), {file.column(), file.time_step(), file.unit()});
}

Motion recorded(const scene::GroundMotion& scene, const std::string& path, double duration) {
  return errors_at(path + ".file.path", [&] {
    Motion record = record_of(scene.file());
    const bool until_given = std::isfinite(scene.until());
    try {
      require_duration(record, until_given ? scene.until() : scene.from() + duration,
                       "the motion " + scene.file().path());
    } catch (const UserError& error) {
      if (until_given) throw;
      throw UserError("", fmt::format("{}, or give `until: {:.6g} s`, after which the ground rests",
                                      error.what(), record.duration()));
    }
    return record;
  });
}

// When a motion that is made by a formula or by chance has ended [s].
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
      return std::isfinite(scene.until()) ? scene.until() : kSyntheticDuration;
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

// The motion before processing. Pulses have a peak of 1 m/s^2, which the `peak` of the scene scales.
Motion raw_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& run) {
  // Its last value is the zero after it, so that a sine that is cut off there ends within a step.
  const Sampling sampling{run.dt, run.dt * (std::ceil(natural_end(scene) / run.dt) + 1)};
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
      return synthetic(scene.synthetic(), {run.dt, natural_end(scene)});
    case Source::SOURCE_NOT_SET:
      break;
  }
  throw UserError(path, "has no motion; give one of file, ricker, sine, gabor, synthetic");
}

// How long the response of the filters to the end of a motion lasts [s]: it falls below 1e-3.
double after_filters(const scene::GroundMotion& scene) {
  constexpr double kPeriods = 3;
  if (scene.has_low_corner()) return kPeriods / scene.low_corner();
  return scene.has_high_corner() ? kPeriods / scene.high_corner() : 0;
}

Motion filtered(const scene::GroundMotion& scene, Motion motion) {
  constexpr int kOrder = 4;
  const bool is_pulse = scene.has_ricker() || scene.has_sine() || scene.has_gabor();
  if (is_pulse) motion = padded(motion, 0, after_filters(scene));
  if (scene.has_low_corner()) motion = high_pass(motion, scene.low_corner(), kOrder, Phase::kZero);
  if (scene.has_high_corner()) motion = low_pass(motion, scene.high_corner(), kOrder, Phase::kZero);
  return motion;
}

// A record at the steps of a solver. It ends as before, although the kernel spreads a little beyond its ends.
Motion at_step(const Motion& record, double dt) {
  if (record.dt == dt) return record;
  const Course course = integrate(record);
  Motion motion = resampled(record, dt, Interpolation::kBandLimited);
  if (motion.acceleration.size() < 4) return motion;
  return ended_with(motion, course.velocity.back(), course.displacement.back());
}

// The straight lines that drive the solver.
Motion driving(const Motion& motion, const Sampling& run, Interpolation interpolation) {
  return interpolation == Interpolation::kBandLimited ? refined(motion, kPartsOfARecord)
                                                      : at_step(motion, run.dt);
}

// The peak is that of what drives the solver: between the values of a record lies more than at them.
Motion whole_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& run,
                    Interpolation interpolation) {
  Motion motion = raw_motion(scene, path, run);
  if (scene.taper() > 0) motion = tapered(motion, scene.taper(), scene.taper());
  motion = filtered(scene, std::move(motion));
  if (scene.baseline()) motion = baseline_corrected(motion);
  if (!scene.has_peak()) return motion;
  return scaled_to_peak(motion, scene.peak(), driving(motion, run, interpolation));
}

void note_synthetic(const scene::GroundMotion& scene, const Sampling& run, UsedMotion& used) {
  if (!scene.has_synthetic()) return;
  constexpr double kAllPeriods = kLongestPeriods * kLongestPeriod;
  if (const double end = natural_end(scene); end < kAllPeriods)
    used.notes.push_back(
        fmt::format("the synthetic motion of {:g} s has periods up to {:.3g} s instead of {:g} s; an "
                    "`until` of {:g} s or more has all of them",
                    end, end / kLongestPeriods, kLongestPeriod, kAllPeriods));
  if (!std::isfinite(scene.until()) && scene.from() + run.duration > kSyntheticDuration * (1 + 1e-9))
    used.notes.push_back(
        fmt::format("the synthetic motion lasts {:g} s, and the ground rests afterwards; give "
                    "`until` for a longer one",
                    kSyntheticDuration));
}

// The velocity of a sine from rest, 1 - cos, never changes its sign.
void note_drift(const scene::GroundMotion& scene, const Motion& whole, UsedMotion& used) {
  constexpr double kDrifts = 2;
  if (!scene.has_sine()) return;
  const double w = 2 * std::numbers::pi * scene.sine().frequency();
  const Peaks most = peaks(whole);
  const double swing = most.acceleration / (w * w);
  if (most.displacement > kDrifts * swing)
    used.notes.push_back(
        fmt::format("the sine begins at rest, so that the ground moves away by up to {:.3g} m, {:.1f} times "
                    "the amplitude of "
                    "{:.3g} m of its swing; give a `taper` of some of its periods, or a `gabor`, to swing "
                    "about its place",
                    most.displacement, most.displacement / swing, swing));
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
        return record_of(scene.file()).dt;
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

UsedMotion used_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& run,
                       Interpolation interpolation) {
  return errors_at(path, [&] {
    const Motion whole = whole_motion(scene, path, run, interpolation);
    UsedMotion used{.motion = at_step(part(whole, scene.from(), scene.until()), run.dt),
                    .duration = run.duration,
                    .interpolation = interpolation,
                    .place = place_at_begin(whole, scene.from(), scene.until()),
                    .notes = notes_on_cut(whole, {scene.from(), scene.until(), run.duration})};
    note_synthetic(scene, run, used);
    note_drift(scene, whole, used);
    used.peak = peaks(beginning(used.acting(), run.duration)).acceleration;
    return used;
  });
}

}  // namespace

Motion UsedMotion::acting(const Motion& other) const {
  return beginning(interpolation == Interpolation::kBandLimited ? refined(other, kPartsOfARecord) : other,
                   2 * duration);
}

std::optional<std::string> note_on_peak(const scene::GroundMotion& scene, const UsedMotion& used) {
  constexpr double kNegligible = 0.01;
  if (!scene.has_peak() || std::abs(used.peak / scene.peak() - 1) <= kNegligible) return std::nullopt;
  return fmt::format(
      "the largest acceleration that acts is {:.4g} m/s^2 instead of `peak` = {:.4g} "
      "m/s^2, because the run takes a part of the motion",
      used.peak, scene.peak());
}

UsedMotion ground_motion(const scene::GroundMotion& scene, const std::string& path,
                         const Sampling& sampling) {
  return used_motion(scene, path, sampling, Interpolation::kLinear);
}

UsedMotion ground_motion(const scene::GroundMotion& scene, const std::string& path, double duration) {
  const double step = natural_step(scene, path);
  if (scene.has_file()) return used_motion(scene, path, {step, duration}, Interpolation::kBandLimited);
  return used_motion(scene, path, {step, step * std::ceil(duration / step)}, Interpolation::kLinear);
}

}  // namespace adit::motion
