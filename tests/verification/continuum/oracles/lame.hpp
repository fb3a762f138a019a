// Thick-walled elastic cylinder in plane strain between pressures (Lame 1852):
//   s_r = A - B/r^2,  s_t = A + B/r^2,  2 G u_r = (1 - 2 nu) A r + B/r.
#pragma once

#include "tests/verification/continuum/oracles/salencon.hpp"

namespace adit::fdm::oracle {

class LameCylinder {
 public:
  // Pressures on the inner and outer wall, compression positive [Pa].
  LameCylinder(double inner, double outer, double inner_pressure, double outer_pressure, double shear_modulus,
               double poisson)
      : b_((inner_pressure - outer_pressure) / (1 / (inner * inner) - 1 / (outer * outer))),
        a_(b_ / (outer * outer) - outer_pressure),
        shear_(shear_modulus),
        poisson_(poisson) {}

  Polar stress(double r) const { return {a_ - b_ / (r * r), a_ + b_ / (r * r)}; }
  double displacement(double r) const { return ((1 - 2 * poisson_) * a_ * r + b_ / r) / (2 * shear_); }

 private:
  double b_, a_, shear_, poisson_;
};

}  // namespace adit::fdm::oracle
