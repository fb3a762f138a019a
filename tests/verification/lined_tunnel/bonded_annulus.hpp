// A thick elastic ring, a < r < b, bonded to elastic ground without end, in plane strain. The far field is
// s_xx = p + tau, s_yy = p - tau: a mean stress and a shear, whose parts vary as 1 and as cos 2theta or sin
// 2theta.
//
// Mean part (Lame), with k = 3 - 4 nu of each body:
//   s_r = A/r^2 + 2C,   s_t = -A/r^2 + 2C,   2G u_r = -A/r + (k - 1) C r;   in the ground C = p/2.
// At r = a: s_r = 0; at r = b: s_r and u_r of both bodies are the same. Three equations.
//
// Shear part: Airy's function (c_1 r^2 + c_2 r^4 + c_3 / r^2 + c_4) cos 2theta (Michell 1899) gives
//   s_r = (-2 c_1 - 6 c_3/r^4 - 4 c_4/r^2) cos 2theta,
//   s_rt = (2 c_1 + 6 c_2 r^2 - 6 c_3/r^4 - 2 c_4/r^2) sin 2theta,
//   s_t = (2 c_1 + 12 c_2 r^2 + 6 c_3/r^4) cos 2theta,
//   2G u_r = (-2 c_1 r + (k - 3) c_2 r^3 + 2 c_3/r^3 + (k + 1) c_4/r) cos 2theta,
//   2G u_t = (2 c_1 r + (k + 3) c_2 r^3 + 2 c_3/r^3 - (k - 1) c_4/r) sin 2theta;
// in the ground c_1 = -tau/2 and c_2 = 0. At r = a: s_r = s_rt = 0; at r = b: s_r, s_rt, u_r, u_t of both
// bodies are the same. Six equations.
//
// Resultants over the thickness, with the middle at (a + b)/2, as sections tell them (sections.hpp):
//   N = int s_t dr,   M = int s_t (r - (a + b)/2) dr,   Q = -int s_rt dr.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>

namespace adit::oracle {

struct Solid {
  double young, poisson;
  double shear_modulus() const { return young / (2 * (1 + poisson)); }
  double kappa() const { return 3 - 4 * poisson; }
};

// Amplitudes: of 1, and of cos 2theta (thrust, moment) or sin 2theta (shear force).
struct RingForces {
  double thrust, moment;
  double thrust_2, moment_2, shear_2;
};

struct Tractions {
  double mean, radial_2, tangential_2;  // amplitudes of s_r: 1, cos 2theta; of s_rt: sin 2theta
};

class BondedAnnulus {
 public:
  BondedAnnulus(const Solid& ring, const Solid& ground, double inner, double outer, double pressure,
                double shear)
      : ring_(ring), ground_(ground), a_(inner), b_(outer), p_(pressure), tau_(shear) {
    solve_mean_part();
    solve_shear_part();
  }

  RingForces forces() const {
    const double middle = (a_ + b_) / 2;
    const auto between = [this](auto&& integral) { return integral(b_) - integral(a_); };
    const auto& c = ring_2_;
    const double mean = between([&](double r) { return ring_a_ / r + 2 * ring_c_ * r; });
    const double mean_arm = between([&](double r) { return -ring_a_ * std::log(r) + ring_c_ * r * r; });
    const double hoop =
        between([&](double r) { return 2 * c[0] * r + 4 * c[1] * r * r * r - 2 * c[2] / (r * r * r); });
    const double hoop_arm =
        between([&](double r) { return c[0] * r * r + 3 * c[1] * std::pow(r, 4) - 3 * c[2] / (r * r); });
    const double sliding = between([&](double r) {
      return 2 * c[0] * r + 2 * c[1] * r * r * r + 2 * c[2] / (r * r * r) + 2 * c[3] / r;
    });
    return {mean, mean_arm - middle * mean, hoop, hoop_arm - middle * hoop, -sliding};
  }

  // In the ground at r.
  Tractions tractions(double r) const {
    const double r2 = r * r, r4 = r2 * r2;
    return {ground_a_ / r2 + p_, tau_ - 6 * ground_2_[0] / r4 - 4 * ground_2_[1] / r2,
            -tau_ - 6 * ground_2_[0] / r4 - 2 * ground_2_[1] / r2};
  }

  // Growth of the diameters of the ring's axis: of the one along x and of the one along y.
  std::array<double, 2> diameter_changes() const {
    const double r = (a_ + b_) / 2, g = 2 * ring_.shear_modulus();
    const double mean = (-ring_a_ / r + (ring_.kappa() - 1) * ring_c_ * r) / g;
    const double oval = terms(r, ring_).row(2).dot(ring_2_) / g;
    return {2 * (mean + oval), 2 * (mean - oval)};
  }

 private:
  // s_r, s_rt, 2G u_r, 2G u_t by c_1, c_2, c_3, c_4.
  static Eigen::Matrix4d terms(double r, const Solid& solid) {
    const double r2 = r * r, r3 = r2 * r, r4 = r2 * r2, k = solid.kappa();
    Eigen::Matrix4d t;
    t << -2, 0, -6 / r4, -4 / r2,                   //
        2, 6 * r2, -6 / r4, -2 / r2,                //
        -2 * r, (k - 3) * r3, 2 / r3, (k + 1) / r,  //
        2 * r, (k + 3) * r3, 2 / r3, -(k - 1) / r;
    return t;
  }

  // The displacements of the ring are multiplied by this: then those of both are 2G of the ground.
  double softness() const { return ground_.shear_modulus() / ring_.shear_modulus(); }

  void solve_mean_part() {
    const double s = softness();
    Eigen::Matrix3d m;                     // A and C of the ring, A of the ground
    m << 1 / (a_ * a_), 2, 0,              //
        1 / (b_ * b_), 2, -1 / (b_ * b_),  //
        -s / b_, s * (ring_.kappa() - 1) * b_, 1 / b_;
    const Eigen::Vector3d right(0, p_, (ground_.kappa() - 1) * p_ / 2 * b_);
    const Eigen::Vector3d x = m.fullPivLu().solve(right);
    ring_a_ = x[0];
    ring_c_ = x[1];
    ground_a_ = x[2];
  }

  void solve_shear_part() {
    const Eigen::Matrix4d inside = terms(a_, ring_), outside = terms(b_, ground_);
    Eigen::Matrix4d face = terms(b_, ring_);
    face.bottomRows<2>() *= softness();
    Eigen::Matrix<double, 6, 6> m = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    m.topLeftCorner<2, 4>() = inside.topRows<2>();
    m.bottomLeftCorner<4, 4>() = face;
    m.bottomRightCorner<4, 2>() = -outside.rightCols<2>();
    right.tail<4>() = outside.col(0) * (-tau_ / 2);
    const Eigen::Matrix<double, 6, 1> x = m.fullPivLu().solve(right);
    ring_2_ = x.head<4>();
    ground_2_ = x.tail<2>();
  }

  Solid ring_, ground_;
  double a_, b_, p_, tau_;
  double ring_a_ = 0, ring_c_ = 0, ground_a_ = 0;
  Eigen::Vector4d ring_2_ = Eigen::Vector4d::Zero();    // c_1 to c_4
  Eigen::Vector2d ground_2_ = Eigen::Vector2d::Zero();  // c_3 and c_4
};

}  // namespace adit::oracle
