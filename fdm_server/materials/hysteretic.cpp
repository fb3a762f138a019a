#include "fdm_server/materials/hysteretic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

constexpr std::size_t kLanes = 8;
using Lanes = std::array<double, kLanes>;

// A deviator of strain or of stress over the shear modulus: (xx - yy)/2, xy, zz of the stress.
struct Deviator {
  double t, s, z;
};

// Half of what product() of two deviators of stress has.
[[gnu::always_inline]] inline double inner(const Deviator& a, const Deviator& b) {
  return (a.t * b.t + a.s * b.s) + 0.75 * (a.z * b.z);
}

// In an order that no width of vectors changes.
[[gnu::always_inline]] inline double sum(const Lanes& v) {
  return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
}

[[gnu::always_inline]] inline double least(const Lanes& v) {
  const auto less = [](double a, double b) { return a < b ? a : b; };
  return less(less(less(v[0], v[4]), less(v[1], v[5])), less(less(v[2], v[6]), less(v[3], v[7])));
}

// Where the values of a state stand. Of the head: the deviator of strain e, the length of its path, the
// length at which a block wakes, the stress at e = 0 without further flow. Of the elements: the length at
// which each block wakes; for each block t, s and z of all q_i; the initial stress.
enum Head : std::size_t { kStrain = 0, kPath = 3, kWakes = 4, kOffset = 5 };
constexpr std::size_t kFlow = 3 * kLanes;

// What the elements did in a step: by how much the sum of G_i/G q_i grew, twice the energy that they
// dissipated over the shear modulus, when the next block wakes.
struct Flowed {
  Deviator flow;
  double dissipated, wakes;
};

// Wakes the blocks whose time has come, at a strain that was `before`.
ADIT_VECTOR_CLONES Flowed wake(std::size_t blocks, const double* stiffness, const double* limit,
                               const Deviator& before, const Deviator& now, double path, double* wakes,
                               double* q) {
  Lanes t_flow{}, s_flow{}, z_flow{}, work{}, slack;
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < blocks; ++b, q += kFlow, stiffness += kLanes, limit += kLanes) {
    if (wakes[b] > path) {
      next = std::min(next, wakes[b]);
      continue;
    }
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
      const Deviator flow{q[i], q[kLanes + i], q[2 * kLanes + i]};
      const Deviator elastic{now.t - flow.t, now.s - flow.s, now.z - flow.z};
      const double size = std::sqrt(inner(elastic, elastic));
      // For von Mises the way back to the yield surface is radial.
      const bool yields = size > limit[i];
      const double ratio = yields ? limit[i] / size : 1, rest = 1 - ratio;
      const Deviator lost{rest * elastic.t, rest * elastic.s, rest * elastic.z};
      // The sum of the elastic strains before and after on the plastic strain; not negative, because none
      // before was larger than the one now along it, but for rounding.
      const Deviator both{(before.t - flow.t) + ratio * elastic.t, (before.s - flow.s) + ratio * elastic.s,
                          (before.z - flow.z) + ratio * elastic.z};
      const double twice = stiffness[i] * inner(both, lost);
      work[i] += twice > 0 ? twice : 0;
      slack[i] = yields ? 0 : limit[i] - size;
      q[i] = flow.t + lost.t;
      q[kLanes + i] = flow.s + lost.s;
      q[2 * kLanes + i] = flow.z + lost.z;
      t_flow[i] += stiffness[i] * lost.t;
      s_flow[i] += stiffness[i] * lost.s;
      z_flow[i] += stiffness[i] * lost.z;
    }
    wakes[b] = path + least(slack);
    next = std::min(next, wakes[b]);
  }
  return {{sum(t_flow), sum(s_flow), sum(z_flow)}, sum(work), next};
}

}  // namespace

Hysteretic::Hysteretic(std::vector<BackbonePoint> backbone) : backbone_(std::move(backbone)) {
  double slope = 1;
  for (std::size_t k = 0; k < backbone_.size(); ++k) {
    const double next = k + 1 < backbone_.size() ? (backbone_[k + 1].stress - backbone_[k].stress) /
                                                       (backbone_[k + 1].strain - backbone_[k].strain)
                                                 : 0;
    // An element that yields takes its stiffness out of the sum, so it is the change of slope at its vertex.
    stiffness_.push_back(slope - next);
    limit_.push_back(backbone_[k].strain);
    slope = next;
  }
  const std::size_t whole = (stiffness_.size() + kLanes - 1) / kLanes * kLanes;
  stiffness_.resize(whole, 0.0);
  limit_.resize(whole, std::numeric_limits<double>::infinity());
}

double Hysteretic::stress(double strain) const {
  double sum = 0;
  for (std::size_t i = 0; i < backbone_.size(); ++i)
    sum += stiffness_[i] * std::min(strain, backbone_[i].strain);
  return sum;
}

double Hysteretic::damping_ratio(double strain) const {
  double twice_area = 0;
  for (std::size_t i = 0; i < backbone_.size(); ++i) {
    const double limit = std::min(strain, backbone_[i].strain);
    // The area under an element's curve: a triangle up to its yield strain, then a rectangle.
    twice_area += stiffness_[i] * limit * (2 * strain - limit);
  }
  return 2 / std::numbers::pi * (twice_area / (stress(strain) * strain) - 1);
}

void Hysteretic::set_stress(const State& state, const SolidStress& stress) const {
  std::ranges::fill(state.head, 0.0);
  std::ranges::fill(state.elements, 0.0);
  const auto initial = state.elements.last(3);
  initial[0] = (stress.xx - stress.yy) / 2;
  initial[1] = stress.xy;
  initial[2] = stress.zz - (stress.xx + stress.yy + stress.zz) / 3;
  std::ranges::copy(initial, state.head.begin() + kOffset);
}

Hysteretic::Chained Hysteretic::add(const Elasticity& elasticity, const Increment& strain,
                                    const State& state) const {
  const double shear = elasticity.shear;
  double* head = state.head.data();
  const Deviator step{strain.difference, strain.shear, -2 * strain.volume / 3};
  const Deviator before{head[kStrain], head[kStrain + 1], head[kStrain + 2]};
  const Deviator now{before.t + step.t, before.s + step.s, before.z + step.z};
  head[kStrain] = now.t;
  head[kStrain + 1] = now.s;
  head[kStrain + 2] = now.z;
  head[kPath] += std::sqrt(inner(step, step));
  double twice = 0;
  if (!(head[kWakes] > head[kPath])) {
    double* wakes = state.elements.data();
    const auto [flow, dissipated, next] =
        wake(blocks(), stiffness_.data(), limit_.data(), before, now, head[kPath], wakes, wakes + blocks());
    head[kWakes] = next;
    head[kOffset] -= shear * flow.t;
    head[kOffset + 1] -= shear * flow.s;
    head[kOffset + 2] -= shear * flow.z;
    twice = dissipated;
  }
  return {shear * now.t + head[kOffset], shear * now.s + head[kOffset + 1], shear * now.z + head[kOffset + 2],
          shear * twice / 2};
}

double Hysteretic::add(const Elasticity& elasticity, const Strain& strain, std::span<double> state,
                       SolidStress& stress) const {
  const double volume = strain.xx + strain.yy;
  const auto [t, s, z, dissipated] =
      add(elasticity, {volume, strain.xx - strain.yy, strain.xy}, split(state));
  const double mean = (stress.xx + stress.yy + stress.zz) / 3 + elasticity.bulk * volume;
  stress = {mean - z / 2 + t, mean - z / 2 - t, mean + z, s};
  return dissipated;
}

double Hysteretic::energy(const Elasticity& elasticity, std::span<const double> head,
                          std::span<const double> elements, const SolidStress& stress) const {
  const Deviator strain{head[kStrain], head[kStrain + 1], head[kStrain + 2]};
  double twice = 0;
  for (std::size_t i = 0; i < backbone_.size(); ++i) {
    const double* q = &elements[blocks() + i / kLanes * kFlow + i % kLanes];
    const Deviator elastic{strain.t - q[0], strain.s - q[kLanes], strain.z - q[2 * kLanes]};
    twice += stiffness_[i] * inner(elastic, elastic);
  }
  const double mean = (stress.xx + stress.yy + stress.zz) / 3;
  const auto initial = elements.last(3);
  return elasticity.shear * twice / 2 + mean * mean / (2 * elasticity.bulk) +
         inner({initial[0], initial[1], initial[2]}, strain);
}

}  // namespace adit::fdm
