// A layered column under vertical shear waves: the scene that computes it, and the transfer function of
// theory.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "fdm_server/materials/damping_law.hpp"

namespace adit::fdm::test {

struct SoilLayer {
  double thickness, shear_velocity, density;
};

// Complex, over that under slow loads: Rayleigh's 1 + i w beta as engineers state it, without the spring
// behind its dashpot; Maxwell's elements as they are.
inline std::complex<double> relative_modulus(const DampingLaw& law, double w) {
  using namespace std::complex_literals;
  std::complex<double> sum = 1;
  for (const auto& element : law.elements)
    sum += 1i * w * element.viscosity() / (law.count() == 1 ? 1.0 : 1.0 + 1i * w * element.relaxation);
  return sum;
}

// Velocity of the surface over that of the base (rigid), or over that of the outcrop of a half-space below
// (compliant), at the frequency [Hz]. In each layer u = cos ks, s the depth below the surface, with damping
//   rho* = rho (1 - i alpha/w),   G* = G relative_modulus(law, w),   k = w sqrt(rho*/G*),
// u and the stress continue through the interfaces; in the half-space, undamped, u = E exp(iks) + F
// exp(-iks), where E rises and the outcrop moves by 2 E = u + tau/(i w rho c).
inline std::complex<double> transfer(const std::vector<SoilLayer>& from_surface, const DampingLaw& law,
                                     const SoilLayer* half_space, double frequency) {
  using Complex = std::complex<double>;
  const Complex i(0, 1);
  const double w = 2 * std::numbers::pi * frequency;
  Complex u = 1, tau = 0;
  for (const auto& [thickness, velocity, density] : from_surface) {
    const Complex modulus = density * velocity * velocity * relative_modulus(law, w);
    const Complex k = w * std::sqrt(density * (1.0 - i * law.alpha / w) / modulus);
    const Complex c = std::cos(k * thickness), s = std::sin(k * thickness),
                  below = u * c + tau * s / (k * modulus);
    tau = tau * c - u * k * modulus * s;
    u = below;
  }
  if (!half_space) return 1.0 / u;
  return 1.0 / (u + tau / (i * w * half_space->density * half_space->shear_velocity));
}

}  // namespace adit::fdm::test
