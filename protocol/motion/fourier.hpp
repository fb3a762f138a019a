// Discrete Fourier transform of real series of even length.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace adit::motion {

// sum x_k exp(-2 pi i j k / n) for j = 0 … n/2, of `values` lengthened with zeros to n.
std::vector<std::complex<double>> transform(std::span<const double> values, std::size_t n);

// Its inverse: n = 2 (spectrum.size() - 1) values.
std::vector<double> inverse_transform(std::span<const std::complex<double>> spectrum);

}  // namespace adit::motion
