// Lamb's problem in the plane (Lamb 1904): a vertical line load P F(t) pushes down on the surface of a
// half-plane; motion of the surface at the distance x > 0, by the method of Cagniard and de Hoop.
//
// With y down, Laplace's s in time and exp(-s p x) along the surface, the potentials A exp(-s a y) and
// B exp(-s b y), a^2 = 1/c_P^2 - p^2, b^2 = 1/c_S^2 - p^2, under s_xy = 0, s_yy = -P give on the surface
//   u_y = P/(mu s) a/(c_S^2 R),   u_x = P/(mu s) p (q - 2 a b)/R,   q = 1/c_S^2 - 2 p^2,  R = q^2 + 4 p^2 a
//   b.
// The inverse integral over imaginary p, turned onto both sides of the real axis, is a Laplace integral over
// the time t = p x: the response to F = delta is 1/(pi x) Im (s u)(p = t/x + i 0). The convolution with F
// passes Rayleigh's pole and the branch points on a path above them, where an entire F may follow.
#pragma once

#include "tests/verification/continuum/oracles/harmonic_wave.hpp"

namespace adit::fdm::oracle {

// The second derivative of a Gaussian, 1 at `peak`, of the dominant frequency `frequency` [Hz]; entire.
struct Ricker {
  double frequency, peak;
  Complex operator()(Complex t) const {
    const Complex a = std::numbers::pi * frequency * (t - peak);
    return (1.0 - 2.0 * a * a) * std::exp(-a * a);
  }
  // Beyond this time from the peak it is less than 1e-14.
  double reach() const { return 6 / (std::numbers::pi * frequency); }
};

// Horizontal displacement away from the load and vertical displacement upwards [m], of the load P = `force`
// [N/m].
template <class Source>
Vector lamb(const Medium& medium, double force, const Source& source, double x, double t) {
  const double slow_p = 1 / medium.p_speed(), slow_s = 1 / medium.s_speed();
  const auto impulse = [&](Complex p) {
    const Complex a = std::sqrt(slow_p * slow_p - p * p), b = std::sqrt(slow_s * slow_s - p * p);
    const Complex q = slow_s * slow_s - 2.0 * p * p, r = q * q + 4.0 * p * p * a * b;
    return std::array{p * (q - 2.0 * a * b) / r, -slow_s * slow_s * a / r};
  };
  // From tau = 0, where all is real, to the end of the source's reach, on half an ellipse above the real
  // axis.
  const double begin = 0, end = t - source.peak + source.reach();
  if (end <= begin) return {0, 0};
  const double centre = (begin + end) / 2, half = (end - begin) / 2,
               height = std::min(half, source.reach() / 8);
  constexpr int kPoints = 2000;
  Vector u{};
  for (int i = 0; i < kPoints; ++i) {
    const double angle = std::numbers::pi * (1 - (i + 0.5) / kPoints);  // midpoint rule
    const Complex tau(centre + half * std::cos(angle), height * std::sin(angle));
    const Complex step(half * std::sin(angle), -height * std::cos(angle));
    const auto [ux, uy] = impulse(tau / x);
    const Complex weight = source(t - tau) * step * (std::numbers::pi / kPoints);
    u[0] += (weight * ux).imag();
    u[1] += (weight * uy).imag();
  }
  const double factor = force / (std::numbers::pi * medium.law.shear * x);
  return {factor * u[0], factor * u[1]};
}

}  // namespace adit::fdm::oracle
