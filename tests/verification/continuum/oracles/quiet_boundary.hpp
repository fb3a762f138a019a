// Plane waves that meet a viscous boundary (Lysmer & Kuhlemeyer 1969) obliquely: the closed form of what
// returns.
//
// The ground x < 0 ends in dashpots, s_xx = -rho c_P u_x', s_xy = -rho c_S u_y'. A wave that comes at the
// angle theta from the normal sends back a P and an SV wave of the same slowness along the boundary; their
// amplitudes are the two unknowns of the two conditions. P and S waves head-on leave entirely.
#pragma once

#include <Eigen/Dense>

#include "tests/verification/continuum/oracles/harmonic_wave.hpp"

namespace adit::fdm::oracle {

enum class Incident { kP, kSv };

struct ViscousReflection {
  HarmonicWave wave;       // incident, of unit amplitude, and reflected
  double returned_energy;  // share of the incident flux through the boundary
};

inline ViscousReflection viscous_reflection(const Medium& medium, Incident incident, double angle,
                                            double omega) {
  const double cp = medium.p_speed(), cs = medium.s_speed();
  const double own = incident == Incident::kP ? cp : cs, along = std::sin(angle) / own;  // slowness along y
  const auto across = [&](double c) { return std::sqrt(Complex(1 / (c * c) - along * along, 0)); };
  // unit displacements; an SV wave beyond the critical angle sends back a P wave that decays from the
  // boundary
  const auto p_part = [&](double sign, Complex amplitude) {
    const Complex x = sign * across(cp);
    return HarmonicWave::Part{{omega * x, omega * along}, {amplitude * cp * x, amplitude * cp * along}};
  };
  const auto s_part = [&](double sign, Complex amplitude) {
    const Complex x = sign * across(cs);
    return HarmonicWave::Part{{omega * x, omega * along}, {-amplitude * cs * along, amplitude * cs * x}};
  };
  const auto excess =
      [&](const HarmonicWave::Part& part) {  // of the boundary's stress over the dashpots', / i omega
        const Complex xx = part.k[0] * part.a[0], yy = part.k[1] * part.a[1];
        const auto& law = medium.law;
        return Eigen::Vector2cd(
            (law.bulk * (xx + yy) + law.shear * (xx - yy)) / omega - medium.density * cp * part.a[0],
            law.shear * (part.k[1] * part.a[0] + part.k[0] * part.a[1]) / omega -
                medium.density * cs * part.a[1]);
      };
  const auto in = incident == Incident::kP ? p_part(1, 1) : s_part(1, 1);
  Eigen::Matrix2cd system;
  system << excess(p_part(-1, 1)), excess(s_part(-1, 1));
  const Eigen::Vector2cd back = system.partialPivLu().solve(-excess(in));
  // flux of a unit wave through the boundary: rho omega^2/2 times c cos(angle)
  const double flux = own * own * across(own).real();
  const double returned =
      (std::norm(back[0]) * cp * cp * across(cp).real() + std::norm(back[1]) * cs * cs * across(cs).real()) /
      flux;
  return {{medium, omega, {in, p_part(-1, back[0]), s_part(-1, back[1])}}, returned};
}

}  // namespace adit::fdm::oracle
