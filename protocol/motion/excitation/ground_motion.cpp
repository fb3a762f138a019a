#include "protocol/motion/excitation/ground_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/motion/errors_at.hpp"
#include "protocol/motion/processing/filter.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/records/records.hpp"
#include "protocol/motion/synthesis/synthetic.hpp"

namespace adit::motion {
namespace {

using protocol::UserError;
using Source = scene::GroundMotion;

Motion recorded(const scene::MotionFile& file, const std::string& path, const Sampling& sampling) {
  return errors_at(path, [&] {
    const Motion record = parse_motion(file.path(), file.content());
    require_duration(record, sampling.duration, "the motion " + file.path());
    const Motion part = cut(record, 0, sampling.duration);
    return part.dt == sampling.dt ? part : resampled(part, sampling.dt, Interpolation::kBandLimited);
  });
}

TargetSpectrum target(const scene::SyntheticMotion& synthetic) {
  if (synthetic.spectrum() == scene::SyntheticMotion::EC8_TYPE_1)
    return ec8_type1(1, static_cast<GroundType>(synthetic.ground()));
  return gb18306(1, synthetic.corner_period());
}

// The shaking grows over the first 15 % of the duration, and decays from its middle on to exp(-3) = 1/20 at
// the end.
Motion synthetic(const scene::SyntheticMotion& scene, const Sampling& sampling) {
  return synthesize({.target = target(scene),
                     .shortest_period = std::max(0.1, 4 * sampling.dt),
                     .longest_period = std::min(4.0, sampling.duration / 3),
                     .dt = sampling.dt,
                     .duration = sampling.duration,
                     .envelope = {.rise = 0.15 * sampling.duration,
                                  .decay = 0.5 * sampling.duration,
                                  .rate = 6 / sampling.duration},
                     .seed = scene.seed()})
      .motion;
}

// The motion before processing. Pulses have a peak of 1 m/s^2, which the `peak` of the scene scales.
Motion raw_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& sampling) {
  switch (scene.source_case()) {
    case Source::kFile:
      return recorded(scene.file(), path + ".file.path", sampling);
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

Motion filtered(const scene::GroundMotion& scene, Motion motion) {
  constexpr int kOrder = 4;
  if (scene.has_low_corner()) motion = high_pass(motion, scene.low_corner(), kOrder, Phase::kZero);
  if (scene.has_high_corner()) motion = low_pass(motion, scene.high_corner(), kOrder, Phase::kZero);
  return motion;
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

Motion ground_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& sampling) {
  return errors_at(path, [&] {
    Motion motion = raw_motion(scene, path, sampling);
    if (scene.taper() > 0) motion = tapered(motion, scene.taper(), scene.taper());
    motion = filtered(scene, std::move(motion));
    if (scene.baseline()) motion = baseline_corrected(motion);
    return scene.has_peak() ? scaled_to_peak(motion, scene.peak()) : motion;
  });
}

Motion ground_motion(const scene::GroundMotion& scene, const std::string& path, double duration) {
  const double step = natural_step(scene, path);
  const bool recorded = scene.source_case() == Source::kFile;
  return ground_motion(scene, path,
                       {.dt = step, .duration = recorded ? duration : step * std::ceil(duration / step)});
}

}  // namespace adit::motion
