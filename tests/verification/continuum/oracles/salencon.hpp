// Circular hole in Mohr-Coulomb ground under equal pressure from all sides, plane strain (Salencon 1969,
// Annales des Ponts et Chaussees 231). The hole's pressure falls from the far pressure p0 to
// `inner_pressure`; a ring of the ground yields. No tension cut-off; the stress along the axis stays between
// the other two.
//
// Compression positive in the derivation, k = c cot(phi), K = (1 + sin phi)/(1 - sin phi), K' the same of
// psi. Yielding ground: s_t + k = K (s_r + k), in equilibrium: s_r + k = A rho^(K-1), A = p_i + k, rho = r/a.
// Beyond the plastic radius R: s = p0 -+ S (R/r)^2, yielding at R: S = B (K-1)/(K+1), B = p0 + k, hence
//   (R/a)^(K-1) = 2 B / ((K+1) A).
// Flow e_r^p = -K' e_t^p with Hooke's law for the stress changes gives, with e_r = -du/dr, e_t = -u/r,
//   -r^(-K') (r^K' u)' = e_r^e + K' e_t^e
//                      = 1/(2G) [((1-nu)(1 + K K') - nu (K + K')) A rho^(K-1) - (1+K')(1-2nu) B],
//   u = -r/(2G) [C A rho^(K-1) - (1-2nu) B + D (R/r)^(K'+1)],  C = (1-nu)(1 + K K')/(K + K') - nu,
// where D joins the elastic u = -S R^2/(2 G r) at R.
#pragma once

#include <cmath>

namespace adit::fdm::oracle {

struct MohrCoulombHole {
  double radius;          // a [m]
  double far_pressure;    // p0, compression positive [Pa]
  double inner_pressure;  // p_i, compression positive [Pa]
  double cohesion;        // c [Pa]
  double friction_angle;  // phi > 0 [rad]
  double dilation_angle;  // psi [rad]
  double shear_modulus;   // G [Pa]
  double poisson;         // nu
};

struct Polar {
  double radial, hoop;  // stress, tension positive [Pa]
};

class Salencon {
 public:
  explicit Salencon(const MohrCoulombHole& hole)
      : hole_(hole),
        k_(hole.cohesion / std::tan(hole.friction_angle)),
        friction_(ratio(hole.friction_angle)),
        dilation_(ratio(hole.dilation_angle)),
        a_(hole.inner_pressure + k_),
        b_(hole.far_pressure + k_),
        drop_(b_ * (friction_ - 1) / (friction_ + 1)),
        plastic_radius_(hole.radius * std::pow(2 * b_ / ((friction_ + 1) * a_), 1 / (friction_ - 1))) {}

  double plastic_radius() const {
    return plastic_radius_;
  }  // [m]; more than `radius` where the ground yields

  Polar stress(double r) const {
    if (r >= plastic_radius_) {
      const double change = drop_ * square(plastic_radius_ / r);
      return {-hole_.far_pressure + change, -hole_.far_pressure - change};
    }
    const double radial = a_ * std::pow(r / hole_.radius, friction_ - 1);
    return {k_ - radial, k_ - friction_ * radial};
  }

  // Radial, outwards: negative where the wall converges [m].
  double displacement(double r) const {
    const double per_strain = -r / (2 * hole_.shear_modulus);
    if (r >= plastic_radius_) return per_strain * drop_ * square(plastic_radius_ / r);
    const double join = drop_ - particular(plastic_radius_);
    return per_strain * (particular(r) + join * std::pow(plastic_radius_ / r, dilation_ + 1));
  }

 private:
  static double ratio(double angle) { return (1 + std::sin(angle)) / (1 - std::sin(angle)); }
  static double square(double value) { return value * value; }
  double particular(double r) const {
    const double nu = hole_.poisson;
    const double c = (1 - nu) * (1 + friction_ * dilation_) / (friction_ + dilation_) - nu;
    return c * a_ * std::pow(r / hole_.radius, friction_ - 1) - (1 - 2 * nu) * b_;
  }

  MohrCoulombHole hole_;
  double k_, friction_, dilation_, a_, b_, drop_, plastic_radius_;
};

}  // namespace adit::fdm::oracle
