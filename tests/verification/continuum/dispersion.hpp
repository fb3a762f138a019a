// How fast waves travel over an infinite regular grid, from the stiffness of its zone.
//
// A wave u_p exp(i (k.x_p - omega t)) over all points meets the same 2 x 2 problem at each of them:
//   sum over the zone's corners a, b of K_ab exp(i k.(x_b - x_a)) u = omega_s^2 m u,  m the mass of a zone;
// central differences of step dt turn omega_s into omega, sin(omega dt/2) = omega_s dt/2.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>

#include "fdm_server/zones/critical_step.hpp"

namespace adit::fdm::test {

class Dispersion {
 public:
  // Rectangular zones; dt as a part of the zone's critical step.
  Dispersion(ZoneKind kind, double width, double height, const PlaneLaw& law, double density,
             double step_factor)
      : x_{0, width, width, 0},
        y_{0, 0, height, height},
        mass_(density * width * height),
        stiffness_(zone_stiffness(kind, {x_, y_}, law)) {
    const auto zone = make_grid({0, width, 0, height, 1, 1});
    dt_ = step_factor * critical_step(kind, zone, law, density);
  }

  // Phase velocities of the S and the P wave with this wave number [1/m] at this angle from the x axis [m/s].
  std::array<double, 2> speeds(double k, double angle) const {
    Eigen::Matrix2cd sum = Eigen::Matrix2cd::Zero();
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        sum += stiffness_.block<2, 2>(2 * a, 2 * b) *
               phase(k * (std::cos(angle) * (x_[b] - x_[a]) + std::sin(angle) * (y_[b] - y_[a])));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2cd> solver(sum / mass_, Eigen::EigenvaluesOnly);
    return {speed(k, solver.eigenvalues()[0]), speed(k, solver.eigenvalues()[1])};
  }

  // Phase velocity of the Rayleigh wave along a free surface in x; the ground is so many rows of zones deep.
  double rayleigh_speed(double k, std::uint32_t rows) const {
    const Eigen::Index size =
        2 * static_cast<Eigen::Index>(rows);  // points from the surface down, the last held
    Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(size + 2, size + 2);
    for (Eigen::Index row = 0; row < rows; ++row)
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
          const auto point = [&](int corner) { return 2 * (y_[corner] > 0 ? row : row + 1); };
          sum.block<2, 2>(point(a), point(b)) +=
              stiffness_.block<2, 2>(2 * a, 2 * b) * (phase(k * (x_[b] - x_[a])) / mass_);
        }
    const double root = std::sqrt(2.0);  // the points of the surface have half the mass
    sum.topRows(2) *= root;
    sum.leftCols(2) *= root;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(sum.topLeftCorner(size, size),
                                                                 Eigen::EigenvaluesOnly);
    return speed(k, solver.eigenvalues()[0]);
  }

 private:
  static std::complex<double> phase(double angle) { return {std::cos(angle), std::sin(angle)}; }
  double speed(double k, double omega_squared) const {
    return 2 / (k * dt_) * std::asin(std::sqrt(omega_squared) * dt_ / 2);
  }

  std::array<double, 4> x_, y_;
  double mass_, dt_ = 0;
  Eigen::Matrix<double, 8, 8> stiffness_;
};

}  // namespace adit::fdm::test
