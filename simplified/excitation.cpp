#include "simplified/excitation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "protocol/errors.hpp"
#include "protocol/motion/filter.hpp"
#include "protocol/motion/processing.hpp"
#include "protocol/motion/pulses.hpp"
#include "protocol/motion/records.hpp"
#include "protocol/motion/stations.hpp"
#include "protocol/motion/synthetic.hpp"
#include "simplified/tunnel.hpp"

namespace adit::simplified {
namespace {

using motion::Motion;
using protocol::UserError;

const std::string kMotion = "simplified.excitation.motion";

// Motions know no scene: their errors get the field that states what they refuse.
template <class Work>
auto at_field(const std::string& field, Work work) {
  try {
    return work();
  } catch (const UserError& error) {
    throw UserError(error.path().empty() ? field : error.path(), error.what());
  }
}

Motion recorded(const scene::MotionFile& file, const FolderOf& folder, double dt, double duration) {
  const std::string field = kMotion + ".file.path";
  return at_field(field, [&] {
    const Motion motion = motion::read_motion(std::filesystem::path(folder(field)) / file.path());
    motion::require_duration(motion, duration, "the motion " + file.path());
    const Motion part = motion::cut(motion, 0, duration);
    return part.dt == dt ? part : motion::resampled(part, dt, motion::Interpolation::kBandLimited);
  });
}

motion::TargetSpectrum target(const scene::SyntheticMotion& synthetic) {
  if (synthetic.spectrum() == scene::SyntheticMotion::EC8_TYPE_1)
    return motion::ec8_type1(1, static_cast<motion::GroundType>(synthetic.ground()));
  return motion::gb18306(1, synthetic.corner_period());
}

// Builds up over 15 % of the duration, decays from half of it to 1/20.
Motion synthetic(const scene::SyntheticMotion& scene, const motion::Sampling& sampling) {
  return motion::synthesize({.target = target(scene),
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

Motion raw_motion(const scene::GroundMotion& scene, const FolderOf& folder,
                  const motion::Sampling& sampling) {
  using Source = scene::GroundMotion;
  switch (scene.source_case()) {
    case Source::kFile:
      return recorded(scene.file(), folder, sampling.dt, sampling.duration);
    case Source::kRicker:
      return motion::ricker(1, scene.ricker().frequency(), scene.ricker().time(), sampling);
    case Source::kSine:
      return motion::sine(1, scene.sine().frequency(), scene.sine().end(), sampling);
    case Source::kGabor:
      return motion::gabor(1, scene.gabor().frequency(), scene.gabor().width(), scene.gabor().phase(),
                           scene.gabor().time(), sampling);
    case Source::kSynthetic:
      return synthetic(scene.synthetic(), sampling);
    case Source::SOURCE_NOT_SET:
      break;
  }
  throw UserError(kMotion, "has no source; give one of file, ricker, sine, gabor, synthetic");
}

Motion filtered(const scene::GroundMotion& scene, Motion motion) {
  constexpr int kOrder = 4;
  if (scene.has_low_corner())
    motion = motion::high_pass(motion, scene.low_corner(), kOrder, motion::Phase::kZero);
  if (scene.has_high_corner())
    motion = motion::low_pass(motion, scene.high_corner(), kOrder, motion::Phase::kZero);
  return motion;
}

void resize(Shaking& shaking, std::size_t places, std::size_t steps) {
  shaking.places = places;
  for (auto* table : {&shaking.displacement, &shaking.velocity, &shaking.acceleration})
    table->assign(places * (steps + 1), 0.0);
}

double value(const std::vector<double>& values, std::size_t step) {
  return step < values.size() ? values[step] : 0.0;
}

// The motions are those of the tunnel's surroundings themselves.
Shaking direct(const std::vector<Motion>& motions, double factor, std::size_t steps) {
  Shaking shaking;
  resize(shaking, motions.size(), steps);
  for (std::size_t p = 0; p < motions.size(); ++p) {
    const motion::Course path = motion::integrate(motions[p]);
    for (std::size_t n = 0; n <= steps; ++n) {
      const std::size_t at = n * motions.size() + p;
      shaking.displacement[at] = factor * value(path.displacement, n);
      shaking.velocity[at] = factor * value(path.velocity, n);
      shaking.acceleration[at] = factor * value(motions[p].acceleration, n);
    }
  }
  return shaking;
}

// The motions are those of the rock; the soil columns carry them up to the tunnel.
Shaking through_ground(const scene::Simplified& scene, const std::vector<column::Column>& columns,
                       Direction direction, const std::vector<Motion>& motions, double factor,
                       std::size_t steps) {
  column::JoinedColumns ground(columns, modulus_ratio(scene.ground(), direction), motions[0].dt,
                               "simplified.ground.profiles");
  std::vector<column::JoinedColumns::Place> places;
  for (std::size_t j = 0; j < columns.size(); ++j)
    places.push_back(ground.place(j, axis_depth(scene.tunnel(), columns[j].chainage)));
  Shaking shaking;
  resize(shaking, columns.size(), steps);
  std::vector<double> rock(columns.size());
  for (std::size_t n = 1; n <= steps; ++n) {
    for (std::size_t j = 0; j < columns.size(); ++j) rock[j] = factor * value(motions[j].acceleration, n);
    ground.step(rock);
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const std::size_t at = n * columns.size() + j;
      shaking.displacement[at] = ground.displacement(places[j]);
      shaking.velocity[at] = ground.velocity(places[j]);
      shaking.acceleration[at] = ground.acceleration(places[j]);
    }
  }
  return shaking;
}

// Where the motion is known: at the soil columns, or close enough for the shortest wave of interest.
std::vector<double> places_along(const scene::Simplified& scene, double begin, double end) {
  std::vector<double> places;
  if (scene.has_ground()) {
    for (const auto& column : columns(scene.ground(), begin, end, kLateral))
      places.push_back(column.chainage);
    return places;
  }
  constexpr int kGaps = 200;
  for (int i = 0; i <= kGaps; ++i) places.push_back(begin + (end - begin) * i / kGaps);
  return places;
}

}  // namespace

Motion ground_motion(const scene::GroundMotion& scene, const FolderOf& folder, double dt, double duration) {
  return at_field(kMotion, [&] {
    Motion motion = filtered(scene, raw_motion(scene, folder, {.dt = dt, .duration = duration}));
    if (scene.baseline()) motion = motion::baseline_corrected(motion);
    return scene.has_peak() ? motion::scaled_to_peak(motion, scene.peak()) : motion;
  });
}

GroundField shake(const scene::Simplified& scene, const Motion& motion, double begin, double end,
                  std::size_t steps) {
  const scene::Excitation& excitation = scene.excitation();
  const std::array<double, kDirections> factors = {excitation.axial(), excitation.lateral(),
                                                   excitation.vertical()};
  if (std::ranges::all_of(factors, [](double f) { return f == 0; }))
    throw UserError("simplified.excitation",
                    "has no direction; give `axial`, `lateral` or `vertical`, such as "
                    "`lateral: 1`");
  if (excitation.through_ground() && !scene.has_ground())
    throw UserError("simplified.excitation.through_ground", "needs the scene's `ground`, which is missing");

  GroundField field;
  field.chainage = places_along(scene, begin, end);
  const scene::Incidence& incidence = excitation.incidence();
  const auto motions = at_field("simplified.excitation.incidence", [&] {
    return motion::station_motions(motion, field.chainage,
                                   {.apparent_velocity = incidence.apparent_velocity(),
                                    .drift = incidence.coherency().drift(),
                                    .seed = incidence.coherency().seed()});
  });
  for (const Direction direction : {kAxial, kLateral, kVertical}) {
    if (factors[direction] == 0) continue;
    field.shaking[direction] = excitation.through_ground()
                                   ? through_ground(scene, columns(scene.ground(), begin, end, direction),
                                                    direction, motions, factors[direction], steps)
                                   : direct(motions, factors[direction], steps);
  }
  return field;
}

}  // namespace adit::simplified
