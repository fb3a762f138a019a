#include "protocol/motion/measures.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "protocol/motion/fourier.hpp"

namespace adit::motion {
namespace {

constexpr double kGravity = 9.80665;  // [m/s^2]

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

}  // namespace

Peaks peaks(const Motion& motion) {
  const Course course = integrate(motion);
  return {largest(motion.acceleration), largest(course.velocity), largest(course.displacement)};
}

double arias_intensity(const Motion& motion) {
  check(motion);
  const auto& a = motion.acceleration;
  double sum = 0;
  for (std::size_t i = 1; i < a.size(); ++i) sum += a[i - 1] * a[i - 1] + a[i - 1] * a[i] + a[i] * a[i];
  return std::numbers::pi / (2 * kGravity) * motion.dt / 3 * sum;
}

FourierSpectrum fourier_spectrum(const Motion& motion) {
  check(motion);
  const std::size_t n = std::bit_ceil(std::max<std::size_t>(2, motion.acceleration.size()));
  const auto values = transform(motion.acceleration, n);
  FourierSpectrum spectrum;
  for (std::size_t k = 0; k < values.size(); ++k) {
    spectrum.frequency.push_back(static_cast<double>(k) / (static_cast<double>(n) * motion.dt));
    spectrum.amplitude.push_back(motion.dt * std::abs(values[k]));
  }
  return spectrum;
}

}  // namespace adit::motion
