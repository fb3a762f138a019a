// The response to a motion by its Fourier transform.
#pragma once

#include <complex>
#include <functional>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace adit::simplified::column::test {

// transfer(omega) for omega > 0; 1 at rest. The motion must have died down before its end.
inline std::vector<double> by_frequency(const std::vector<double>& motion, double dt,
                                        const std::function<std::complex<double>(double)>& transfer) {
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> spectrum;
  fft.fwd(spectrum, motion);
  const std::size_t n = motion.size();
  const double step = 2 * std::numbers::pi / (static_cast<double>(n) * dt);
  for (std::size_t k = 1; k < n; ++k)
    spectrum[k] *= k <= n / 2 ? transfer(static_cast<double>(k) * step)
                              : std::conj(transfer(static_cast<double>(n - k) * step));
  std::vector<double> result;
  fft.inv(result, spectrum);
  return result;
}

// A pulse of about `frequency` [Hz] around t = 1.5 s, in 2^15 samples.
inline std::vector<double> pulse(double dt, double frequency) {
  std::vector<double> motion(1 << 15);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double t = static_cast<double>(i) * dt - 1.5;
    motion[i] = std::cos(2 * std::numbers::pi * frequency * t) * std::exp(-t * t / 0.08);
  }
  return motion;
}

}  // namespace adit::simplified::column::test
