// Random numbers that are the same on every machine. The C++ standard fixes the output of mt19937_64, but not
// that of the standard distributions, which are therefore not used.
#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <random>

namespace adit::motion {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  // Uniform in [0, 1), from the upper 53 bits, as many as the mantissa of a double has.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  // Complex Gaussian with mean 0 and mean |z|^2 = 1 (Box and Muller 1958).
  std::complex<double> complex_gaussian() {
    const double radius = std::sqrt(-std::log(1 - uniform()));
    return std::polar(radius, 2 * std::numbers::pi * uniform());
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace adit::motion
