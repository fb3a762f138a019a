// Isotropic linear elasticity in the plane, as the 2-D bulk and shear modulus:
//   p = kappa (exx + eyy),   t = mu (exx - eyy),   s = mu gamma_xy,
// with p = (sxx + syy)/2, t = (sxx - syy)/2, s = sxy. The plane conditions differ in kappa only.
#pragma once

namespace adit::fdm {

struct PlaneLaw {
  double bulk;   // kappa = lambda + mu [Pa]
  double shear;  // mu [Pa]

  // sxx = young_prime exx in uniaxial stress in the plane: E (plane stress), E/(1 - nu^2) (plane strain).
  double young_prime() const { return 4 * bulk * shear / (bulk + shear); }
  // -eyy/exx there: nu (plane stress), nu/(1 - nu) (plane strain).
  double poisson_prime() const { return (bulk - shear) / (bulk + shear); }
};

// E > 0 [Pa], -1 < nu < 0.5.
inline PlaneLaw plane_strain(double young, double poisson) {
  return {young / (2 * (1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))};
}
inline PlaneLaw plane_stress(double young, double poisson) {
  return {young / (2 * (1 - poisson)), young / (2 * (1 + poisson))};
}

// Stress in one zone, tension positive [Pa].
struct Stress {
  double xx, yy, xy;
};

}  // namespace adit::fdm
