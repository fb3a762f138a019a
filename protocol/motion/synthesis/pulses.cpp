#include "protocol/motion/synthesis/pulses.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"

namespace adit::motion {
namespace {

using protocol::UserError;
using std::numbers::pi;

constexpr double kMostValues = 1e8;

void check_pulse(double peak, double frequency, const Sampling& sampling) {
  require_positive(sampling.dt, "time step of the motion");
  require_positive(sampling.duration, "duration of the motion");
  require_positive(frequency, "frequency of the motion");
  if (!std::isfinite(peak))
    throw UserError("", fmt::format("the peak of the motion is {}; give a finite one", peak));
  if (2 * frequency * sampling.dt >= 1)
    throw UserError(
        "", fmt::format("the frequency of the motion is {:.6g} Hz; at steps of {:.6g} s give one below "
                        "{:.6g} Hz",
                        frequency, sampling.dt, 0.5 / sampling.dt));
  if (sampling.duration / sampling.dt > kMostValues)
    throw UserError("", "the motion has more than 1e8 values; give a longer step or a shorter duration");
}

template <class Function>
Motion sampled(const Sampling& sampling, const Function& value_at) {
  const auto count = static_cast<std::size_t>(sampling.duration / sampling.dt * (1 + 1e-12)) + 1;
  Motion motion{sampling.dt, std::vector<double>(count)};
  for (std::size_t i = 0; i < count; ++i)
    motion.acceleration[i] = value_at(static_cast<double>(i) * sampling.dt);
  check(motion);
  return motion;
}

}  // namespace

Motion ricker(double peak, double frequency, double centre, const Sampling& sampling) {
  check_pulse(peak, frequency, sampling);
  return sampled(sampling, [=](double t) {
    const double x = pi * frequency * (t - centre);
    return peak * (1 - 2 * x * x) * std::exp(-x * x);
  });
}

Motion sine(double peak, double frequency, double end, const Sampling& sampling) {
  check_pulse(peak, frequency, sampling);
  require_positive(end, "end of the sine");
  return sampled(sampling,
                 [=](double t) { return t <= end ? peak * std::sin(2 * pi * frequency * t) : 0.0; });
}

Motion gabor(double peak, double frequency, double width, double phase, double centre,
             const Sampling& sampling) {
  check_pulse(peak, frequency, sampling);
  require_positive(width, "width of the motion");
  return sampled(sampling, [=](double t) {
    const double angle = 2 * pi * frequency * (t - centre);
    return peak * std::exp(-(angle / width) * (angle / width)) * std::cos(angle + phase);
  });
}

}  // namespace adit::motion
