// A circular lining in elastic ground under far-field shear tau, in plane strain. Turned by 45 degrees the
// shear is a stress tau along x and -tau along y; all that follows is at the angle 0 of that frame, times cos
// 2theta (thrust, moment) or sin 2theta (shear force).
//
// Wang, J.-N. 1993: Seismic design of tunnels, Parsons Brinckerhoff monograph 7, as in Hashash et al. 2001,
// Tunnelling and Underground Space Technology 16: thrust without slip (K2), thrust and moment with full slip
// (K1). Penzien, J. 2000: Seismically induced racking of tunnel linings, Earthquake Eng. Struct. Dyn. 29.
//
// Both closed forms simplify: Penzien's thrust without slip is far too small (Hashash et al. 2005), and his
// moment without slip leaves out that the tangential stress, too, turns the lining back, which makes it too
// large except in nearly incompressible ground. Hence the full solution beside them. Ground: Airy's function
// (A + B/r^2) cos 2theta (Michell 1899) on top of the far field,
//   s_r = (tau - 4A/r^2 - 6B/r^4) cos 2theta,   s_rt = (-tau - 2A/r^2 - 6B/r^4) sin 2theta,
//   2G u_r = (tau r + (k + 1) A/r + 2B/r^3) cos 2theta,   2G u_t = (-tau r - (k - 1) A/r + 2B/r^3) sin
//   2theta,
// k = 3 - 4 nu. Lining with u_r = U cos 2theta, u_t = V sin 2theta at its radius R, a ring of Timoshenko's:
//   N = EA (U + 2V)/R,   Q = 4 EI (V + 2U)/(R^3 (1 + 4 EI/(GA_s R^2))),   M = Q R/2,
//   s_r = N/R + 2Q/R,   s_rt = 2N/R + Q/R       (derivatives of its energy by U and V)
// are two linear equations for A and B.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "fdm_server/structures/beam.hpp"

namespace adit::fdm::oracle {

struct Tunnel {
  double shear_modulus, poisson;  // of the ground
  double radius;
  Section lining;  // of plane strain

  // E/(1 - nu^2) I and A of the lining are what the closed forms know of it.
  double compressibility() const { return 2 * shear_modulus * radius / (lining.axial * (1 - 2 * poisson)); }
  double flexibility() const { return shear_modulus * std::pow(radius, 3) / (3 * lining.bending); }
};

struct Forces {
  double thrust, moment;  // largest, without sign, by shear strain gamma = tau/G = 1
};

inline Forces wang_full_slip(const Tunnel& t) {
  const double k1 = 12 * (1 - t.poisson) / (2 * t.flexibility() + 5 - 6 * t.poisson);
  const double thrust = k1 / 3 * t.shear_modulus * t.radius;
  return {thrust, thrust * t.radius};
}

inline double wang_thrust_without_slip(const Tunnel& t) {
  const double nu = t.poisson, n = 1 - 2 * nu, c = t.compressibility(), f = t.flexibility();
  const double k2 = 1 + (f * (n - n * c) - n * n / 2 + 2) /
                            (f * ((3 - 2 * nu) + n * c) + c * (2.5 - 8 * nu + 6 * nu * nu) + 6 - 8 * nu);
  return k2 * t.shear_modulus * t.radius;
}

// M = 6 E'I d/D^2, d = R^n gamma D/2, R^n = 4 (1 - nu)/(a + 1), a = 24 E'I (3 - 4 nu)/(D^3 G).
inline double penzien_moment_without_slip(const Tunnel& t) {
  const double diameter = 2 * t.radius;
  const double a = 24 * t.lining.bending * (3 - 4 * t.poisson) / (std::pow(diameter, 3) * t.shear_modulus);
  return 3 * t.lining.bending / diameter * 4 * (1 - t.poisson) / (a + 1);
}

// Thrust under the far stress p on all sides: the ground moves by 2G u = 2 (1 - nu) p R - s R where it bears
// s, the lining by u = s R^2/EA, N = s R.
inline double thrust_under_pressure(const Tunnel& t, double p) {
  return 2 * (1 - t.poisson) * p * t.radius / (1 + 2 * t.shear_modulus * t.radius / t.lining.axial);
}

// Ring and ground under the shear stress tau at infinity.
class Ovaling {
 public:
  Ovaling(const Tunnel& tunnel, double tau) : t_(tunnel), tau_(tau), a_(0), b_(0) {
    const double r = t_.radius;
    const Eigen::Vector2d without = residual(0, 0);
    Eigen::Matrix2d slope;
    slope << residual(r * r * tau, 0) - without, residual(0, std::pow(r, 4) * tau) - without;
    const Eigen::Vector2d share = slope.partialPivLu().solve(-without);
    a_ = share[0] * r * r * tau;
    b_ = share[1] * std::pow(r, 4) * tau;
  }

  double thrust() const {
    return t_.lining.axial * (radial(t_.radius) + 2 * tangential(t_.radius)) / t_.radius;
  }
  double shear() const {
    const double r = t_.radius, flexible = 4 * t_.lining.bending / (t_.lining.shear * r * r);
    return 4 * t_.lining.bending * (tangential(r) + 2 * radial(r)) / (r * r * r * (1 + flexible));
  }
  double moment() const { return shear() * t_.radius / 2; }

  // In the ground at r: amplitudes of s_r and s_rt.
  double radial_stress(double r) const { return tau_ - 4 * a_ / (r * r) - 6 * b_ / std::pow(r, 4); }
  double shear_stress(double r) const { return -tau_ - 2 * a_ / (r * r) - 6 * b_ / std::pow(r, 4); }

  double radial(double r) const {  // U [m]
    return (tau_ * r + (kappa() + 1) * a_ / r + 2 * b_ / (r * r * r)) / (2 * t_.shear_modulus);
  }
  double tangential(double r) const {  // V
    return (-tau_ * r - (kappa() - 1) * a_ / r + 2 * b_ / (r * r * r)) / (2 * t_.shear_modulus);
  }

 private:
  double kappa() const { return 3 - 4 * t_.poisson; }
  Eigen::Vector2d residual(double a, double b) {
    a_ = a;
    b_ = b;
    const double r = t_.radius;
    return {(thrust() + 2 * shear()) / r - radial_stress(r), (2 * thrust() + shear()) / r - shear_stress(r)};
  }

  Tunnel t_;
  double tau_, a_, b_;
};

}  // namespace adit::fdm::oracle
