#include "fdm_server/materials/pm4sand.hpp"

#include <algorithm>
#include <cmath>

#include "fdm_server/materials/pm4sand_point.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

using namespace pm4sand;

constexpr std::uint32_t kTogether = 64;  // points whose parts are taken in turn
constexpr double kMostParts = 1000;      // so that a run that has lost its way ends
constexpr std::size_t kChanging = kPm4SandFields - 3;

Constants constants(const Pm4Sand& sand, bool reconsolidates = false) {
  const double density = sand.relative_density, over = density - 0.26;
  const double loss = std::clamp(0.5 - 1.5 * (density - 0.55), 0.2, 0.5);
  const double voids = kMostVoids - (kMostVoids - kLeastVoids) * density;
  return {sand.modulus_coefficient * kAtmosphere,
          sand.largest_pressure,
          sand.contraction_rate,
          std::max(0.3, (0.25 + density) / 2),
          (1 + voids) / (kMostVoids - kLeastVoids),
          std::min(5 + 25 * (density - 0.35), 10.0),
          std::clamp(5 + 220 * over * over * over, 4.0, 35.0),
          loss * loss,
          reconsolidates ? std::min(0.03 * std::exp(2.6 * density), 0.99) : 1};
}

// Points that have more than `part` parts take one.
ADIT_VECTOR_CLONES void strain_part(const Constants& c, const Pm4SandPoints& points, const double* parts,
                                    double part) {
  const auto& [count, compaction, difference, shear, pressure, shear_t, shear_s, fields] = points;
  const auto f = fields;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto pair = [&](std::size_t n) { return PlaneVector{f[n][i], f[n + 1][i]}; };
    Pm4SandState q{pair(0),  pair(2),  pair(4),  pair(6),  pair(8),  pair(10), pair(12), pair(14), f[16][i],
                   f[17][i], f[18][i], f[19][i], f[20][i], f[21][i], f[22][i], f[23][i], f[24][i], f[25][i]};
    Pm4SandStress stress{pressure[i], {shear_t[i], shear_s[i]}};
    const double share = 1 / parts[i];
    strain(c, share * compaction[i], {share * difference[i], share * shear[i]}, stress, q);
    const bool takes = part < parts[i];
    const double changed[] = {
        q.alpha.t,         q.alpha.s,        q.start.t,        q.start.s,        q.apparent.t, q.apparent.s,
        q.before.t,        q.before.s,       q.least.t,        q.least.s,        q.most.t,     q.most.s,
        q.fabric.t,        q.fabric.s,       q.fabric_start.t, q.fabric_start.s, q.fabric_sum, q.fabric_peak,
        q.fabric_pressure, q.fabric_product, q.density,        q.shear_modulus,  q.reduction};
    static_assert(std::size(changed) == kChanging);
#pragma GCC unroll 32
    for (std::size_t n = 0; n < kChanging; ++n) f[n][i] = vectors::choose(takes, changed[n], f[n][i]);
    pressure[i] = vectors::choose(takes, stress.pressure, pressure[i]);
    shear_t[i] = vectors::choose(takes, stress.shear.t, shear_t[i]);
    shear_s[i] = vectors::choose(takes, stress.shear.s, shear_s[i]);
  }
}

// `count` points from one on.
Pm4SandPoints some_of(const Pm4SandPoints& points, std::uint32_t first, std::uint32_t count) {
  Pm4SandPoints some = points;
  some.count = count;
  for (const double** values : {&some.compaction, &some.difference, &some.shear}) *values += first;
  for (double** values : {&some.pressure, &some.shear_t, &some.shear_s}) *values += first;
  for (double*& values : some.state) values += first;
  return some;
}

}  // namespace

double modulus_coefficient(double relative_density) {
  return 167 * std::sqrt(46 * relative_density * relative_density + 2.5);
}

Pm4SandState begin(const Pm4Sand& sand, Pm4SandStress& stress) {
  const double p_min = std::max(stress.pressure, kAtmosphere) / 200, p = std::max(stress.pressure, p_min);
  const auto [xi, bounding, dilating] = surfaces(sand.relative_density, p);
  const double outer = std::max(bounding, dilating);
  stress.pressure = std::max(stress.pressure, p_min / 5);
  const double beyond = 2 * length(stress.shear) / (outer * stress.pressure);
  if (beyond > 1) stress.shear = 1 / beyond * stress.shear;
  Pm4SandState q{};
  q.alpha = (beyond > 1 ? 1 - kYield / outer : 1) / stress.pressure * stress.shear;
  q.start = q.least = q.most = q.alpha;
  q.largest_fabric = std::min(0.7 * std::exp(-6.1 * xi), 20.0);
  q.fabric_peak = q.largest_fabric / 1e5;
  q.fabric_pressure = p / 100;
  q.fabric_product = -1;
  q.density = sand.relative_density;
  q.least_pressure = p_min;
  q.dilatancy = 1.24;
  if (xi < 0)
    q.dilatancy = bounding > 2
                      ? 1.5
                      : 2.5 * (std::asin(bounding / 2) - std::asin(kCritical / 2)) / (bounding - dilating);
  q.shear_modulus = shear_modulus(constants(sand), q, stress, bounding);
  q.reduction = 1;
  return q;
}

void advance(const Pm4Sand& sand, const Pm4SandPoints& points, bool reconsolidates) {
  const Constants c = constants(sand, reconsolidates);
  for (std::uint32_t first = 0; first < points.count; first += kTogether) {
    const Pm4SandPoints some = some_of(points, first, std::min(points.count - first, kTogether));
    std::array<double, kTogether> parts;
    double most = 0;
    for (std::uint32_t i = 0; i < some.count; ++i) {
      const double size = std::max(std::abs(some.compaction[i]), length({some.difference[i], some.shear[i]}));
      parts[i] = std::clamp(std::ceil(size / kLargestPart), 1.0, kMostParts);
      most = std::max(most, parts[i]);
    }
    for (double part = 0; part < most; ++part) strain_part(c, some, parts.data(), part);
  }
}

Elasticity small_strain_elasticity(const Pm4Sand& sand, double pressure) {
  const double shear =
      sand.modulus_coefficient * std::sqrt(kAtmosphere * std::min(pressure, sand.largest_pressure));
  return {kPm4SandBulk * shear, shear};
}

}  // namespace adit::fdm
