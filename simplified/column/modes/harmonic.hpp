// Standing waves within one layer, and their exact integrals.
#pragma once

#include <cmath>
#include <complex>

namespace adit::simplified::column {

// f(s) = Re(amplitude * exp(i wave_number s)), s the distance below the layer's top.
struct Harmonic {
  std::complex<double> amplitude;
  double wave_number;  // [1/m]
};

// The same wave, with s counted from a point that lies `distance` deeper.
inline Harmonic further_down(const Harmonic& f, double distance) {
  return {f.amplitude * std::polar(1.0, f.wave_number * distance), f.wave_number};
}

inline Harmonic derivative(const Harmonic& f) {
  return {f.amplitude * std::complex<double>(0, f.wave_number), f.wave_number};
}

// int_0^h exp(i k s) ds = h exp(i k h/2) sin(k h/2)/(k h/2), smooth through k = 0.
inline std::complex<double> integral_of_wave(double wave_number, double h) {
  const double half = wave_number * h / 2;
  return h * (half == 0 ? 1 : std::sin(half) / half) * std::polar(1.0, half);
}

// int_0^h f ds
inline double integral(const Harmonic& f, double h) {
  return (f.amplitude * integral_of_wave(f.wave_number, h)).real();
}

// int_0^h f g ds, from f g = 1/2 Re(F G exp(i (k_f + k_g) s) + F G* exp(i (k_f - k_g) s)).
inline double integral(const Harmonic& f, const Harmonic& g, double h) {
  return 0.5 * (f.amplitude * g.amplitude * integral_of_wave(f.wave_number + g.wave_number, h) +
                f.amplitude * std::conj(g.amplitude) * integral_of_wave(f.wave_number - g.wave_number, h))
                   .real();
}

}  // namespace adit::simplified::column
