// Discrete Fourier transform of real series of even length.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace adit::motion {

// The sums over k of x_k exp(-2 pi i j k / n) for j = 0 … n/2, with x = `values`, padded with zeros to length
// n.
std::vector<std::complex<double>> transform(std::span<const double> values, std::size_t n);

// The inverse of transform(): n = 2 (spectrum.size() - 1) values.
std::vector<double> inverse_transform(std::span<const std::complex<double>> spectrum);

}  // namespace adit::motion
