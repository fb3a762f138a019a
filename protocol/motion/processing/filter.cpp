#include "protocol/motion/processing/filter.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/motion/fourier.hpp"

namespace adit::motion {
namespace {

using protocol::UserError;

enum class Pass { kLow, kHigh };

void check_filter(const Motion& motion, double corner, int order) {
  check(motion);
  require_positive(corner, "corner frequency of the filter");
  const double nyquist = 0.5 / motion.dt;
  if (corner >= nyquist)
    throw UserError(
        "", fmt::format("the corner frequency of the filter is {:.6g} Hz; at steps of {:.6g} s give one "
                        "below {:.6g} Hz",
                        corner, motion.dt, nyquist));
  if (order < 1 || order > 20)
    throw UserError("", fmt::format("the order of the filter is {}; give one from 1 to 20", order));
}

Motion zero_phase(const Motion& motion, Pass pass, double corner, int order) {
  const std::size_t n = std::bit_ceil(2 * motion.acceleration.size());
  auto spectrum = transform(motion.acceleration, n);
  for (std::size_t k = 0; k < spectrum.size(); ++k) {
    const double ratio = static_cast<double>(k) / (static_cast<double>(n) * motion.dt * corner);
    const double power = std::pow(ratio, 2 * order);
    const double squared = pass == Pass::kLow ? 1 / (1 + power) : 1 - 1 / (1 + power);
    spectrum[k] *= std::sqrt(squared);
  }
  Motion result{motion.dt, inverse_transform(spectrum)};
  result.acceleration.resize(motion.acceleration.size());
  return result;
}

// y = b0 x + b1 x' + b2 x'' - a1 y' - a2 y''; one prime means the step before, two the one before that.
struct Section {
  double b0, b1, b2, a1, a2;
};

void run_section(const Section& s, std::vector<double>& values) {
  double later = 0,
         last =
             0;  // transposed direct form II: what the past adds to the next value, and to the one after it
  for (double& value : values) {
    const double x = value;
    value = s.b0 * x + later;
    later = s.b1 * x - s.a1 * value + last;
    last = s.b2 * x - s.a2 * value;
  }
}

// The analogue low passes are 1/(p^2 + p/q + 1) and 1/(p + 1) with p = s/w_c; high passes have p^2 and p in
// the numerator. The bilinear transform that keeps the corner frequency is p = (1 - z) / (k (1 + z)) with k =
// tan(pi f_c dt), where z delays by one step.
Section second_order(Pass pass, double k, double inverse_q) {
  const double scale = 1 / (1 + k * inverse_q + k * k);
  const double a1 = 2 * (k * k - 1) * scale, a2 = (1 - k * inverse_q + k * k) * scale;
  if (pass == Pass::kLow) return {k * k * scale, 2 * k * k * scale, k * k * scale, a1, a2};
  return {scale, -2 * scale, scale, a1, a2};
}

Section first_order(Pass pass, double k) {
  const double scale = 1 / (1 + k), a1 = (k - 1) * scale;
  if (pass == Pass::kLow) return {k * scale, k * scale, 0, a1, 0};
  return {scale, -scale, 0, a1, 0};
}

// The poles of a Butterworth filter of order n lie on a circle, at the angles pi (2 i + 1) / (2 n) from the
// imaginary axis. Each pair of poles makes a second-order section, a single real pole a first-order one.
Motion causal(const Motion& motion, Pass pass, double corner, int order) {
  const double k = std::tan(std::numbers::pi * corner * motion.dt);
  Motion result = motion;
  for (int i = 0; i < order / 2; ++i)
    run_section(second_order(pass, k, 2 * std::sin(std::numbers::pi * (2 * i + 1) / (2 * order))),
                result.acceleration);
  if (order % 2 == 1) run_section(first_order(pass, k), result.acceleration);
  return result;
}

Motion filtered(const Motion& motion, Pass pass, double corner, int order, Phase phase) {
  check_filter(motion, corner, order);
  return phase == Phase::kZero ? zero_phase(motion, pass, corner, order)
                               : causal(motion, pass, corner, order);
}

}  // namespace

Motion low_pass(const Motion& motion, double corner, int order, Phase phase) {
  return filtered(motion, Pass::kLow, corner, order, phase);
}

Motion high_pass(const Motion& motion, double corner, int order, Phase phase) {
  return filtered(motion, Pass::kHigh, corner, order, phase);
}

}  // namespace adit::motion
