// The reference of hysteretic zones: Iwan's elements at a point, one after another, all in every step, as
// their definition says (fdm_server/hysteresis/iwan_elements.hpp).
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "fdm_server/hysteresis/iwan_elements.hpp"
#include "fdm_server/materials/solid.hpp"

namespace adit::fdm::test {

class IwanPoint {
 public:
  IwanPoint(const Elasticity& elasticity, const IwanElements& elements)
      : shear_(elasticity.shear), elements_(elements), elastic_(elements.limit.size()) {}

  // The sum of the elements' deviators, (xx - yy)/2, xy and zz, and the energy per volume that they
  // dissipated.
  struct Sum {
    double difference = 0, shear = 0, across = 0, dissipated = 0;
  };
  // By growths of strain: xx + yy, xx - yy, xy.
  Sum add(double volume, double difference, double shear) {
    Sum sum;
    for (std::size_t i = 0; i < elastic_.size(); ++i) {
      const Deviator before = elastic_[i];
      const Deviator trial{before.t + difference, before.s + shear, before.z - 2 * volume / 3};
      const double size = std::sqrt(inner(trial, trial)), limit = elements_.limit[i];
      const double ratio = size > limit ? limit / size : 1;
      const Deviator now{ratio * trial.t, ratio * trial.s, ratio * trial.z};
      const Deviator mean{(before.t + now.t) / 2, (before.s + now.s) / 2, (before.z + now.z) / 2};
      const Deviator flow{(1 - ratio) * trial.t, (1 - ratio) * trial.s, (1 - ratio) * trial.z};
      const double modulus = shear_ * elements_.stiffness[i];
      sum.difference += modulus * now.t;
      sum.shear += modulus * now.s;
      sum.across += modulus * now.z;
      sum.dissipated += modulus * inner(mean, flow);
      elastic_[i] = now;
    }
    return sum;
  }

 private:
  // Of strain; (xx - yy), xy, and zz as it enters the stress.
  struct Deviator {
    double t = 0, s = 0, z = 0;
  };
  static double inner(const Deviator& a, const Deviator& b) {
    return a.t * b.t + a.s * b.s + 0.75 * a.z * b.z;
  }

  double shear_;
  const IwanElements& elements_;
  std::vector<Deviator> elastic_;
};

}  // namespace adit::fdm::test
