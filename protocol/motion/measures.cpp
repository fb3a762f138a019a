#include "protocol/motion/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/motion/fourier.hpp"

namespace adit::motion {
namespace {

constexpr double kGravity = 9.80665;  // [m/s^2]

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

// Integral of the squared acceleration up to each time of the motion [m^2/s^3], exact for straight lines
// between its values: over a step from a to b it is dt (a^2 + a b + b^2) / 3.
std::vector<double> squares(const Motion& motion) {
  check(motion);
  const auto& a = motion.acceleration;
  std::vector<double> sums(a.size());
  for (std::size_t i = 1; i < a.size(); ++i)
    sums[i] = sums[i - 1] + motion.dt / 3 * (a[i - 1] * a[i - 1] + a[i - 1] * a[i] + a[i] * a[i]);
  return sums;
}

}  // namespace

Peaks peaks(const Motion& motion, double place) {
  Course course = integrate(motion);
  for (double& displacement : course.displacement) displacement += place;
  return {largest(motion.acceleration), largest(course.velocity), largest(course.displacement)};
}

double arias_intensity(const Motion& motion) {
  return std::numbers::pi / (2 * kGravity) * squares(motion).back();
}

std::vector<double> husid(const Motion& motion) {
  std::vector<double> course = squares(motion);
  if (const double end = course.back(); end > 0)
    for (double& value : course) value /= end;
  return course;
}

double significant_duration(const Motion& motion, double from, double to) {
  if (!(from >= 0 && from < to && to <= 1))
    throw protocol::UserError(
        "", fmt::format("the shares {} and {} of the Arias intensity do not bound a duration; "
                        "give two ascending shares from 0 to 1",
                        from, to));
  const std::vector<double> course = husid(motion);
  if (course.back() == 0) return 0;
  const auto time_of = [&](double share) {
    const auto after = std::max(std::ranges::lower_bound(course, share), course.begin() + 1);
    const double rise = *after - *(after - 1), part = rise > 0 ? (share - *(after - 1)) / rise : 1;
    return motion.dt * (static_cast<double>(after - course.begin() - 1) + part);
  };
  return time_of(to) - time_of(from);
}

double cumulative_absolute_velocity(const Motion& motion) {
  check(motion);
  double sum = 0;
  for (std::size_t i = 1; i < motion.acceleration.size(); ++i) {
    const double a = motion.acceleration[i - 1], b = motion.acceleration[i];
    // A line that changes its sign makes two triangles with the axis.
    sum += a * b >= 0 ? std::abs(a + b) : (a * a + b * b) / std::abs(a - b);
  }
  return motion.dt / 2 * sum;
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

double frequency_below(const Motion& motion, double share) {
  const FourierSpectrum spectrum = fourier_spectrum(motion);
  std::vector<double> energy;
  double sum = 0;
  for (const double amplitude : spectrum.amplitude) energy.push_back(sum += amplitude * amplitude);
  return sum > 0 ? spectrum.frequency[static_cast<std::size_t>(std::ranges::lower_bound(energy, share * sum) -
                                                               energy.begin())]
                 : 0;
}

}  // namespace adit::motion
