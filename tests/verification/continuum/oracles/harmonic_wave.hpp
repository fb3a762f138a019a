// Time-harmonic waves in a homogeneous elastic plane, as sums of plane and evanescent waves:
//   u = Re sum_j a_j exp(i (k_j . x - omega t)),  k_j complex.
// Each part solves rho u'' = div sigma for k.k = (omega/c_P)^2 with a along k, or k.k = (omega/c_S)^2 with a
// across it.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "fdm_server/materials/plane_law.hpp"

namespace adit::fdm::oracle {

using Complex = std::complex<double>;
using Vector = std::array<double, 2>;

struct Medium {
  PlaneLaw law;
  double density;                                                                 // [kg/m^3]
  double p_speed() const { return std::sqrt((law.bulk + law.shear) / density); }  // [m/s]
  double s_speed() const { return std::sqrt(law.shear / density); }
};

class HarmonicWave {
 public:
  struct Part {
    std::array<Complex, 2> k;  // [1/m]
    std::array<Complex, 2> a;  // amplitude [m]
  };
  HarmonicWave(const Medium& medium, double omega, std::vector<Part> parts)
      : medium_(medium), omega_(omega), parts_(std::move(parts)) {}

  const Medium& medium() const { return medium_; }
  double omega() const { return omega_; }  // [rad/s]

  Vector displacement(double x, double y, double t) const {
    return sum(x, y, t, [](const Part& part, std::size_t axis) { return part.a[axis]; });
  }
  Vector velocity(double x, double y, double t) const {
    return sum(x, y, t,
               [this](const Part& part, std::size_t axis) { return Complex(0, -omega_) * part.a[axis]; });
  }
  Stress stress(double x, double y, double t) const {
    Stress stress{};
    for (const auto& part : parts_) {
      const Complex i = Complex(0, 1) * phase(part, x, y, t);
      const Complex xx = i * part.k[0] * part.a[0], yy = i * part.k[1] * part.a[1];
      const double p = medium_.law.bulk * (xx + yy).real(), q = medium_.law.shear * (xx - yy).real();
      stress.xx += p + q;
      stress.yy += p - q;
      stress.xy += medium_.law.shear * (i * (part.k[1] * part.a[0] + part.k[0] * part.a[1])).real();
    }
    return stress;
  }

 private:
  Complex phase(const Part& part, double x, double y, double t) const {
    return std::exp(Complex(0, 1) * (part.k[0] * x + part.k[1] * y - omega_ * t));
  }
  Vector sum(double x, double y, double t, const auto& amplitude) const {
    Vector total{};
    for (const auto& part : parts_)
      for (std::size_t axis = 0; axis < 2; ++axis)
        total[axis] += (phase(part, x, y, t) * amplitude(part, axis)).real();
    return total;
  }

  Medium medium_;
  double omega_;
  std::vector<Part> parts_;
};

// Plane waves of unit amplitude that travel at `angle` from the x axis [rad].
inline HarmonicWave p_wave(const Medium& medium, double wavelength, double angle) {
  const double k = 2 * std::numbers::pi / wavelength, c = std::cos(angle), s = std::sin(angle);
  return {medium, k * medium.p_speed(), {{{k * c, k * s}, {c, s}}}};
}
inline HarmonicWave sv_wave(const Medium& medium, double wavelength, double angle) {
  const double k = 2 * std::numbers::pi / wavelength, c = std::cos(angle), s = std::sin(angle);
  return {medium, k * medium.s_speed(), {{{k * c, k * s}, {-s, c}}}};
}

// The root 0 < c < c_S of Rayleigh's function (2 - c^2/c_S^2)^2 - 4 sqrt(1 - c^2/c_P^2) sqrt(1 - c^2/c_S^2),
// negative below the root and positive at c_S, by bisection.
inline double rayleigh_speed(const Medium& medium) {
  const double p = medium.p_speed(), s = medium.s_speed();
  const auto rayleigh = [&](double c) {
    const double a = 1 - c * c / (p * p), b = 1 - c * c / (s * s);
    return (1 + b) * (1 + b) - 4 * std::sqrt(a * b);
  };
  double low = 0.1 * s, high = s;  // the trivial root c = 0 stays outside
  for (int i = 0; i < 100; ++i) (rayleigh((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return (low + high) / 2;
}

// Rayleigh's wave along the free surface y = 0 of the ground y < 0: the potentials A exp(p y) and B exp(s y)
// times exp(i (k x - omega t)), u = grad A-part + rot B-part, joined by s_xy = 0; s_yy = 0 is Rayleigh's
// equation.
inline HarmonicWave rayleigh_wave(const Medium& medium, double wavelength) {
  const double k = 2 * std::numbers::pi / wavelength, c = rayleigh_speed(medium);
  const double p = k * std::sqrt(1 - std::pow(c / medium.p_speed(), 2));
  const double s = k * std::sqrt(1 - std::pow(c / medium.s_speed(), 2));
  const Complex i(0, 1), a = 1 / k, b = -2.0 * i * k * p / (s * s + k * k) * a;
  return {medium, k * c, {{{k, -i * p}, {i * k * a, p * a}}, {{k, -i * s}, {s * b, -i * k * b}}}};
}

}  // namespace adit::fdm::oracle
