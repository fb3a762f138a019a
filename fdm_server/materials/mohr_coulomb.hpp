// Mohr-Coulomb with tension cut-off, perfectly plastic for one strength; the strength may soften from step to
// step.
//
// Yield planes in principal stresses, largest first s1 >= s2 >= s3:
//   shear    F_ij = s_i (1 + sin phi) - s_j (1 - sin phi) - 2 c cos phi <= 0,   flow: the same with psi for
//   phi, tension  T_i  = s_i - t <= 0,                                               flow: along s_i.
// An elastic predictor s* outside goes back by Koiter's rule, s = s* - sum l_k C m_k with l_k >= 0, F_k <= 0,
// l_k F_k = 0, exact for the planes' edges and corners (de Borst 1987; Clausen, Damkilde & Andersen 2006,
// Int. J. Numer. Meth. Eng. 66): the planes that are active are found by trial among the six that can be,
// F_13, F_23, F_12 and T_1, T_2, T_3. The principal directions do not change.
#pragma once

#include <vector>

#include "fdm_server/materials/solid.hpp"

namespace adit::fdm {

struct Strength {
  double cohesion;        // [Pa]
  double friction_angle;  // [rad]
  double dilation_angle;  // [rad], at most the friction angle
  double tension;  // [Pa], at most the apex; infinite where friction_angle is 0 and there is no cut-off
};

// The apex of a cone without cut-off: c / tan(phi) [Pa]; infinite without friction.
double apex(double cohesion, double friction_angle);

// The strength at a plastic shear strain (shear_measure).
struct SofteningRow {
  double strain;
  Strength strength;
};

// What the yield planes need of a strength.
struct YieldCone {
  double sin_friction, sin_dilation, twice_c_cos, tension;
};

// Of so many times the cohesion and tension.
[[gnu::always_inline]] inline YieldCone times(double factor, const YieldCone& cone) {
  return {cone.sin_friction, cone.sin_dilation, factor * cone.twice_c_cos, factor * cone.tension};
}

class MohrCoulomb {
 public:
  explicit MohrCoulomb(const Strength& strength) : MohrCoulomb({{0.0, strength}}) {}
  // Rows by increasing strain from 0.
  explicit MohrCoulomb(std::vector<SofteningRow> rows);

  struct Return {
    SolidStress stress;
    unsigned yields;  // kShearNow, kTensionNow
  };
  // The predicted stress where it is admissible, or the stress that it returns to.
  Return admissible(const Elasticity& elasticity, double plastic_shear_strain,
                    const SolidStress& predicted) const;

  Strength strength(double plastic_shear_strain) const;
  YieldCone cone(double plastic_shear_strain) const;
  bool softens() const { return rows_.size() > 1; }

 private:
  std::vector<SofteningRow> rows_;
  YieldCone first_;
};

}  // namespace adit::fdm
