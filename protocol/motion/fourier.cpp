#include "protocol/motion/fourier.hpp"

#include <unsupported/Eigen/FFT>

namespace adit::motion {

std::vector<std::complex<double>> transform(std::span<const double> values, std::size_t n) {
  std::vector<double> series(values.begin(), values.end());
  series.resize(n);
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> spectrum;
  fft.fwd(spectrum, series);
  return spectrum;
}

std::vector<double> inverse_transform(std::span<const std::complex<double>> spectrum) {
  const std::vector<std::complex<double>> half(spectrum.begin(), spectrum.end());
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<double> values;
  fft.inv(values, half, 2 * (std::ssize(half) - 1));
  return values;
}

}  // namespace adit::motion
