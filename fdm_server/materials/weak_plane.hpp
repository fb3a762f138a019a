// The ubiquitous weak plane: slip by Coulomb and opening across planes of one direction, after the law of the
// ground between them. With the traction on the plane, normal s_n and shear tau,
//   slip     |tau| + s_n tan phi - c <= 0,   flow (|gamma|, e_n) = l (1, tan psi),
//   opening  s_n - t <= 0,                   flow e_n,
// and the elastic predictor goes back by Koiter's rule, as in mohr_coulomb.hpp; e_n takes lame() from the
// stress along and across, lame() + 2G from s_n.
#pragma once

#include "fdm_server/materials/mohr_coulomb.hpp"
#include "fdm_server/materials/solid.hpp"

namespace adit::fdm {

class WeakPlane {
 public:
  // `dip_angle`: of the trace, from x counter-clockwise [rad].
  WeakPlane(double dip_angle, const Strength& strength);

  struct Return {
    SolidStress stress;
    unsigned yields;  // kSlipNow, kOpeningNow
  };
  // `turn`: by which the ground has turned since, counter-clockwise [rad].
  Return admissible(const Elasticity& elasticity, const SolidStress& predicted, double turn = 0) const;

 private:
  double dip_angle_, cosine_, sine_;
  double cohesion_, tan_friction_, tan_dilation_, tension_;
};

}  // namespace adit::fdm
