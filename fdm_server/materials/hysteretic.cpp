#include "fdm_server/materials/hysteretic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace adit::fdm {
namespace {

// A stress deviator; its second invariant is t^2 + s^2 + 3/4 z^2.
struct Deviator {
  double t, s, z;  // (xx - yy)/2, xy, zz
};

// With it the elastic energy s : s / 4G of the deviator is square / 2G.
double square(const Deviator& d) {
  return d.t * d.t + d.s * d.s + 0.75 * d.z * d.z;
}

Deviator deviator(std::span<const double> state, std::size_t i) {
  return {state[3 * i], state[3 * i + 1], state[3 * i + 2]};
}

}  // namespace

Hysteretic::Hysteretic(std::vector<BackbonePoint> backbone) : backbone_(std::move(backbone)) {
  double slope = 1;
  for (std::size_t k = 0; k < backbone_.size(); ++k) {
    const double next = k + 1 < backbone_.size() ? (backbone_[k + 1].stress - backbone_[k].stress) /
                                                       (backbone_[k + 1].strain - backbone_[k].strain)
                                                 : 0;
    // An element that yields takes its stiffness out of the sum, so it is the change of slope at its vertex.
    elements_.push_back({slope - next, (slope - next) * backbone_[k].strain});
    slope = next;
  }
}

double Hysteretic::stress(double strain) const {
  double sum = 0;
  for (std::size_t i = 0; i < elements_.size(); ++i)
    sum += elements_[i].stiffness * std::min(strain, backbone_[i].strain);
  return sum;
}

double Hysteretic::damping_ratio(double strain) const {
  double twice_area = 0;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const double limit = std::min(strain, backbone_[i].strain);
    // The area under an element's curve: a triangle up to its yield strain, then a rectangle.
    twice_area += elements_[i].stiffness * limit * (2 * strain - limit);
  }
  return 2 / std::numbers::pi * (twice_area / (stress(strain) * strain) - 1);
}

void Hysteretic::set_stress(std::span<double> state, const SolidStress& stress) const {
  std::ranges::fill(state, 0.0);
  double* initial = &state[3 * elements_.size()];
  initial[0] = (stress.xx - stress.yy) / 2;
  initial[1] = stress.xy;
  initial[2] = stress.zz - (stress.xx + stress.yy + stress.zz) / 3;
}

double Hysteretic::add(const Elasticity& elasticity, const Strain& strain, std::span<double> state,
                       SolidStress& stress) const {
  const double volume = strain.xx + strain.yy + strain.zz;
  const double dt = elasticity.shear * (strain.xx - strain.yy), ds = elasticity.shear * strain.xy;
  const double dz = 2 * elasticity.shear * (strain.zz - volume / 3);
  const auto n = elements_.size();
  Deviator sum = deviator(state, n);  // the initial stress
  double twice_dissipated = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [stiffness, strength] = elements_[i];
    double* element = &state[3 * i];
    const double limit = strength * elasticity.shear;
    const Deviator before{element[0], element[1], element[2]};
    Deviator now{before.t + stiffness * dt, before.s + stiffness * ds, before.z + stiffness * dz};
    const double predicted = square(now);
    if (predicted > limit * limit) {
      // For von Mises the way back to the yield surface is radial, so the deviator is scaled.
      const double ratio = limit / std::sqrt(predicted);
      const Deviator lost{(1 - ratio) * now.t, (1 - ratio) * now.s, (1 - ratio) * now.z};
      now = {ratio * now.t, ratio * now.s, ratio * now.z};
      // the mean stress of the step times the plastic strain, lost / stiffness; not negative, because no
      // stress before was larger than the one now along it, but for rounding
      const double twice =
          (before.t + now.t) * lost.t + (before.s + now.s) * lost.s + 0.75 * (before.z + now.z) * lost.z;
      twice_dissipated += std::max(twice, 0.0) / stiffness;
    }
    element[0] = now.t;
    element[1] = now.s;
    element[2] = now.z;
    sum.t += now.t;
    sum.s += now.s;
    sum.z += now.z;
  }
  double* strains = &state[3 * (n + 1)];
  strains[0] += strain.xx - strain.yy;
  strains[1] += strain.xy;
  strains[2] += volume;

  const double mean = (stress.xx + stress.yy + stress.zz) / 3 + elasticity.bulk * volume;
  stress = {mean - sum.z / 2 + sum.t, mean - sum.z / 2 - sum.t, mean + sum.z, sum.s};
  return twice_dissipated / (2 * elasticity.shear);
}

void Hysteretic::turn(std::span<double> state, double cosine, double sine) const {
  const double c2 = cosine * cosine - sine * sine, s2 = 2 * cosine * sine;
  const auto turn_pair = [&](double& t, double& s) {
    const double first = t;
    t = c2 * first - s2 * s;
    s = s2 * first + c2 * s;
  };
  const auto n = elements_.size();
  for (std::size_t i = 0; i <= n; ++i) turn_pair(state[3 * i], state[3 * i + 1]);
  // xx - yy and xy of strain turn like twice (xx - yy)/2 and twice xy
  turn_pair(state[3 * (n + 1)], state[3 * (n + 1) + 1]);
}

double Hysteretic::energy(const Elasticity& elasticity, std::span<const double> state,
                          const SolidStress& stress) const {
  const auto n = elements_.size();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += square(deviator(state, i)) / elements_[i].stiffness;
  const double mean = (stress.xx + stress.yy + stress.zz) / 3;
  const Deviator initial = deviator(state, n);
  const double* strains = &state[3 * (n + 1)];
  // its power on xx - yy, xy and the volume: zz is 0, so that the deviator of zz is minus a third of the
  // volume
  return sum / (2 * elasticity.shear) + mean * mean / (2 * elasticity.bulk) + initial.t * strains[0] +
         initial.s * strains[1] - initial.z * strains[2] / 2;
}

bool Hysteretic::yields(const Elasticity& elasticity, std::span<const double> state) const {
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const double limit = elements_[i].strength * elasticity.shear;
    // The return leaves an element at its limit but for rounding errors.
    if (square(deviator(state, i)) >= (1 - 1e-12) * limit * limit) return true;
  }
  return false;
}

}  // namespace adit::fdm
