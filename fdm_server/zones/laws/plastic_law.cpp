#include "fdm_server/zones/laws/plastic_law.hpp"

#include <algorithm>
#include <limits>

#include "fdm_server/materials/admissible.hpp"
#include "fdm_server/materials/demand.hpp"

namespace adit::fdm {
namespace {

constexpr unsigned kNow = kShearNow | kTensionNow | kSlipNow | kOpeningNow;
constexpr std::uint32_t kPast = (kNow << 2) * 0x01010101u;  // of all four points

Plasticity plasticity(const Material& material) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  Plasticity law{material.elasticity(), {0, 0, kNone, kNone}, false, material.weak_plane.has_value(), {}};
  if (material.mohr_coulomb) law.cone = material.mohr_coulomb->cone(0);
  if (material.mohr_coulomb) law.softens = material.mohr_coulomb->softens();
  if (material.weak_plane) law.plane = material.weak_plane->strength();
  return law;
}

}  // namespace

PlasticLaw::PlasticLaw(const Material& material, std::size_t zones, bool large_strain,
                       std::span<const double> strengths)
    : ZoneLaw(material.elasticity()),
      material_(material),
      law_(plasticity(material)),
      strains_(zones),
      yields_(zones, 0),
      strengths_(strengths.begin(), strengths.end()) {
  if (law_.softens) {
    cones_.emplace(zones);
    for (std::size_t zone = 0; zone < zones; ++zone)
      for (std::size_t k = 0; k < 4; ++k) soften(zone, k);
  }
  ones_.fill(1);
  if (!material.weak_plane) return;
  const auto [cosine, sine] = material.weak_plane->direction();
  cosine_.fill(cosine);
  sine_.fill(sine);
  if (!large_strain) return;
  directions_.emplace(zones);
  std::ranges::fill((*directions_)[0], cosine);
  std::ranges::fill((*directions_)[1], sine);
}

ConeView PlasticLaw::cones(std::size_t first) const {
  ConeView view{};
  if (cones_)
    for (std::size_t field = 0; field < kConeFields; ++field)
      for (std::size_t k = 0; k < 4; ++k) view.fields[field][k] = &(*cones_)[4 * field + k][first];
  return view;
}

DirectionView PlasticLaw::directions(std::size_t first) const {
  if (directions_) return {&(*directions_)[0][first], &(*directions_)[1][first]};
  return {cosine_.data(), sine_.data()};
}

void PlasticLaw::advance(const LawStep& step) {
  add_elastic(step.count, elasticity_, step.strains, step.stresses);
  return_to_strength(step);
}

bool PlasticLaw::return_to_strength(const LawStep& step) {
  for (std::uint32_t i = 0; i < step.count; ++i) yields_[step.first + i] &= kPast;
  BatchFlags outside;
  const Outside how = find_outside(law_, step.count, step.stresses, cones(step.first), directions(step.first),
                                   strengths(step.first), outside);
  if (how == kHolds) return false;

  Returning zones;
  Numbers numbers;
  zones.count = 0;
  for (std::uint32_t i = 0; i < step.count; ++i) {
    numbers[zones.count] = i;
    zones.count += outside[i] != 0;
  }
  pack(step, numbers, zones);
  const Regions likely = how == kSheared ? Regions::kShearPlane : Regions::kCutOffPoint;
  if (return_points(law_, likely, zones) && return_points(law_, Regions::kAll, zones))
    return_one_by_one(step, numbers, zones);
  average_and_dissipate(law_, zones);
  unpack(step, numbers, zones);
  return true;
}

void PlasticLaw::pack(const LawStep& step, const Numbers& numbers, Returning& zones) const {
  const auto take = [&, all = zones.count == step.count](const double* from, BatchValues& to) {
    if (all)
      std::copy_n(from, zones.count, to.begin());
    else
      for (std::uint32_t i = 0; i < zones.count; ++i) to[i] = from[numbers[i]];
  };
  take(step.stresses.mean, zones.mean);
  take(step.stresses.across, zones.across);
  take(step.strains.volume.data(), zones.volume);
  take(strengths(step.first), zones.strength);
  for (std::size_t k = 0; k < 4; ++k) {
    take(step.stresses.difference[k], zones.difference[k]);
    take(step.stresses.shear[k], zones.shear[k]);
    take(step.strains.difference[k].data(), zones.strain_difference[k]);
    take(step.strains.shear[k].data(), zones.strain_shear[k]);
    take(step.areas[k].data(), zones.area[k]);
  }
  if (cones_)
    for (std::size_t field = 0; field < kConeFields; ++field)
      for (std::size_t k = 0; k < 4; ++k) take(cones(step.first).fields[field][k], zones.cones[field][k]);
  if (law_.has_plane) {
    take(directions(step.first).cosine, zones.cosine);
    take(directions(step.first).sine, zones.sine);
  }
}

// A stress within so many times the strength is so many times one within the strength.
void PlasticLaw::return_one_by_one(const LawStep& step, const Numbers& numbers, Returning& zones) const {
  for (std::size_t k = 0; k < 4; ++k)
    for (std::uint32_t i = 0; i < zones.count; ++i) {
      if (zones.yields[k][i] != kOpen) continue;
      const std::size_t zone = step.first + numbers[i];
      const double factor = strength(zone);
      const auto [stress, sheared, yields] =
          admissible(material_, elasticity_, strains_[k][zone],
                     1 / factor * solid_stress(zones.predicted(k, i)), {zones.cosine[i], zones.sine[i]});
      zones.set(k, i, point_stress(factor * stress));
      zones.sheared[k][i] = factor * sheared;
      zones.yields[k][i] = yields;
    }
}

void PlasticLaw::unpack(const LawStep& step, const Numbers& numbers, const Returning& zones) {
  const bool all = zones.count == step.count;
  const auto put = [&](const BatchValues& from, double* to) {
    if (all)
      std::copy_n(from.begin(), zones.count, to);
    else
      for (std::uint32_t i = 0; i < zones.count; ++i) to[numbers[i]] = from[i];
  };
  const auto add = [&](const BatchValues& from, double* to) {
    if (all)
      for (std::uint32_t i = 0; i < zones.count; ++i) to[i] += from[i];
    else
      for (std::uint32_t i = 0; i < zones.count; ++i) to[numbers[i]] += from[i];
  };
  put(zones.mean, step.stresses.mean);
  put(zones.across, step.stresses.across);
  add(zones.dissipated, step.dissipated);
  for (std::size_t k = 0; k < 4; ++k) {
    put(zones.to_difference[k], step.stresses.difference[k]);
    put(zones.to_shear[k], step.stresses.shear[k]);
    add(zones.sheared[k], &strains_[k][step.first]);
  }
  std::uint32_t* yields = &yields_[step.first];
  for (std::uint32_t i = 0; i < zones.count; ++i) {
    std::uint32_t now = 0;
    for (std::uint32_t k = 0; k < 4; ++k) now |= static_cast<std::uint32_t>(zones.yields[k][i]) << (8 * k);
    yields[numbers[i]] |= now | now << 2;  // a bit of the past is its bit of now, times 4
  }
  if (!cones_) return;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::uint32_t i = 0; i < zones.count; ++i)
      if (zones.sheared[k][i] > 0) soften(step.first + numbers[i], k);
}

void PlasticLaw::soften(std::size_t zone, std::size_t k) {
  const auto [sin_friction, sin_dilation, twice_c_cos, tension] = cone(zone, k);
  auto& cones = *cones_;
  cones[k][zone] = sin_friction;
  cones[4 + k][zone] = sin_dilation;
  cones[8 + k][zone] = twice_c_cos;
  cones[12 + k][zone] = tension;
}

double PlasticLaw::demand(std::size_t zone, std::size_t point, const PointStress& stress) const {
  double largest = 0;
  if (material_.mohr_coulomb) largest = fdm::demand(cone(zone, point), stress);
  if (law_.has_plane) {
    const std::size_t first = zone - zone % kBatch;
    const DirectionView to = directions(first);
    largest = std::max(largest, fdm::demand(times(strength(zone), law_.plane),
                                            {to.cosine[zone - first], to.sine[zone - first]}, stress));
  }
  return largest;
}

void PlasticLaw::turn(std::size_t first, std::uint32_t count, const HalfTurns& turns) {
  if (!directions_) return;
  for (std::uint32_t i = 0; i < count; ++i) {
    double &cosine = (*directions_)[0][first + i], &sine = (*directions_)[1][first + i];
    const PlaneDirection to = turned(PlaneDirection{cosine, sine}, turns.cosine[i], turns.sine[i]);
    cosine = to.cosine;
    sine = to.sine;
  }
}

void PlasticLaw::exchange(state::Archive& archive) {
  strains_.exchange(archive);
  archive("yields", std::span(yields_));
  if (directions_) directions_->exchange(archive);
  if (!cones_ || !archive.reads()) return;
  for (std::size_t zone = 0; zone < yields_.size(); ++zone)
    for (std::size_t k = 0; k < 4; ++k) soften(zone, k);
}

}  // namespace adit::fdm
