// Circular hole in an elastic plate, its wall free, under the far stresses xx, yy, xy (Kirsch 1898;
// Timoshenko & Goodier, Theory of Elasticity, 3rd ed., art. 35). Displacements in plane strain by
// Muskhelishvili's potentials.
//
// 2 G (u + i v) = kappa phi - z conj(phi') - conj(psi),  s_xx + s_yy = 4 Re phi',
// s_yy - s_xx + 2 i s_xy = 2 (conj(z) phi'' + psi'),  kappa = 3 - 4 nu;  with S = (xx + yy)/2,
// T = (xx - yy)/2 - i xy (far field phi' = S/2, psi' = -T) the wall |z| = a is free of traction for
//   phi = S/2 z + conj(T) a^2/z,   psi = -T z - S a^2/z + conj(T) a^4/z^3.
#pragma once

#include <complex>

namespace adit::fdm::oracle {

struct CartesianStress {
  double xx, yy, xy;  // tension positive [Pa]
};

class Kirsch {
 public:
  Kirsch(double radius, const CartesianStress& far, double shear_modulus, double poisson)
      : a2_(radius * radius),
        s_((far.xx + far.yy) / 2),
        t_((far.xx - far.yy) / 2, -far.xy),
        shear_(shear_modulus),
        kappa_(3 - 4 * poisson) {}

  CartesianStress stress(double x, double y) const {
    const Complex z(x, y), z2 = z * z;
    const Complex phi1 = s_ / 2 - std::conj(t_) * a2_ / z2, phi2 = 2.0 * std::conj(t_) * a2_ / (z2 * z);
    const Complex psi1 = -t_ + s_ * a2_ / z2 - 3.0 * std::conj(t_) * a2_ * a2_ / (z2 * z2);
    const double sum = 4 * phi1.real();
    const Complex difference = 2.0 * (std::conj(z) * phi2 + psi1);
    return {(sum - difference.real()) / 2, (sum + difference.real()) / 2, difference.imag() / 2};
  }

  // u + i v [m], of the far stresses and the hole together
  std::complex<double> displacement(double x, double y) const {
    const Complex z(x, y);
    const Complex phi = s_ / 2 * z + std::conj(t_) * a2_ / z, phi1 = s_ / 2 - std::conj(t_) * a2_ / (z * z);
    const Complex psi = -t_ * z - s_ * a2_ / z + std::conj(t_) * a2_ * a2_ / (z * z * z);
    return (kappa_ * phi - z * std::conj(phi1) - std::conj(psi)) / (2 * shear_);
  }

 private:
  using Complex = std::complex<double>;
  double a2_, s_;
  Complex t_;
  double shear_, kappa_;
};

}  // namespace adit::fdm::oracle
