#include "tests/support/column/wave_theory.hpp"

#include <algorithm>

namespace adit::simplified::column::test {

// The wave is followed from the free surface (u = 1, tau = 0) downwards. With k = omega/V and the impedance
// Z, both complex, a layer of thickness h changes it to
//     u(h) = u cos kh + tau/(omega Z) sin kh,   tau(h) = tau cos kh - omega Z u sin kh.
// In the rock u = E exp(ikz) + F exp(-ikz) and tau = i omega Z_r (E - F). E is the rising wave, and the
// outcrop moves by 2 E = u + tau / (i omega Z_r).
std::complex<double> wave_transfer(const Deposit& deposit, double frequency, double depth) {
  using Complex = std::complex<double>;
  const Complex i(0, 1);
  Complex u = 1, tau = 0, u_at_depth = 1;
  double top = 0;
  for (const Layer& layer : deposit.layers) {
    const Complex root = std::sqrt(1.0 + 2.0 * i * layer.damping);
    const Complex k = frequency / (layer.wave_velocity * root),
                  stiffness = frequency * layer.impedance() * root;
    const auto down = [&](double h) { return u * std::cos(k * h) + tau / stiffness * std::sin(k * h); };
    if (depth >= top) u_at_depth = down(std::min(depth - top, layer.thickness));
    const Complex below = down(layer.thickness);
    tau = tau * std::cos(k * layer.thickness) - stiffness * u * std::sin(k * layer.thickness);
    u = below;
    top += layer.thickness;
  }
  const Complex given = deposit.rock ? u + tau / (i * frequency * deposit.rock->impedance()) : u;
  return u_at_depth / given;
}

}  // namespace adit::simplified::column::test
