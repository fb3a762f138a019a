#include "protocol/motion/spectra/response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/motion/measures.hpp"

namespace adit::motion {
namespace {

using protocol::UserError;

// Takes the oscillator over one step h under the acceleration a + s t, 0 <= t <= h. The particular solution
// is
//   u_p = -(a + s t)/w^2 + 2 damping s/w^3,   v_p = -s/w^2.
// The difference from it is a free oscillation, which the matrix (uu_ uv_; vu_ vv_) takes over the step.
class Oscillator {
 public:
  Oscillator(double period, double damping, double h)
      : per_h_(1 / h), w_(2 * std::numbers::pi / period), damping_(damping) {
    flexibility_ = 1 / (w_ * w_);
    lag_ = 2 * damping * flexibility_ / w_;
    const double damped = w_ * std::sqrt(1 - damping * damping);
    const double decay = std::exp(-damping * w_ * h), sine = decay * std::sin(damped * h),
                 cosine = decay * std::cos(damped * h);
    uu_ = cosine + damping * w_ / damped * sine;
    uv_ = sine / damped;
    vu_ = -w_ * w_ / damped * sine;
    vv_ = cosine - damping * w_ / damped * sine;
  }

  void step(double a, double a_end) {
    const double slope = (a_end - a) * per_h_, v_forced = -slope * flexibility_, lag = slope * lag_;
    const double u_free = u + a * flexibility_ - lag, v_free = v - v_forced;
    u = uu_ * u_free + uv_ * v_free - a_end * flexibility_ + lag;
    v = vu_ * u_free + vv_ * v_free + v_forced;
  }

  // The absolute acceleration u'' + a, from the equation of motion.
  double absolute_acceleration() const { return -2 * damping_ * w_ * v - w_ * w_ * u; }

  double u = 0, v = 0;

 private:
  double per_h_, w_, damping_, flexibility_, lag_;  // 1/h, w, damping, 1/w^2, 2 damping/w^3
  double uu_, uv_, vu_, vv_;
};

void check_damping(double damping) {
  if (!(damping >= 0 && damping < 1))
    throw UserError("", fmt::format("the damping ratio is {}; give one from 0 to below 1", damping));
}

struct PeakResponse {
  double displacement = 0, velocity = 0, absolute_acceleration = 0;
};

PeakResponse peak_response(const Motion& motion, double period, double damping) {
  const int parts = std::max(1, static_cast<int>(std::ceil(40 * motion.dt / period)));
  Oscillator oscillator(period, damping, motion.dt / parts);
  PeakResponse peak;
  for (std::size_t i = 1; i < motion.acceleration.size(); ++i) {
    const double a = motion.acceleration[i - 1], rise = (motion.acceleration[i] - a) / parts;
    for (int part = 0; part < parts; ++part) {
      oscillator.step(a + part * rise, a + (part + 1) * rise);
      peak.displacement = std::max(peak.displacement, std::abs(oscillator.u));
      peak.velocity = std::max(peak.velocity, std::abs(oscillator.v));
      peak.absolute_acceleration =
          std::max(peak.absolute_acceleration, std::abs(oscillator.absolute_acceleration()));
    }
  }
  return peak;
}

}  // namespace

OscillatorResponse oscillator_response(const Motion& motion, double period, double damping) {
  check(motion);
  require_positive(period, "period of the oscillator");
  check_damping(damping);
  const std::size_t count = motion.acceleration.size();
  OscillatorResponse response{std::vector<double>(count), std::vector<double>(count),
                              std::vector<double>(count)};
  Oscillator oscillator(period, damping, motion.dt);
  for (std::size_t i = 1; i < count; ++i) {
    oscillator.step(motion.acceleration[i - 1], motion.acceleration[i]);
    response.displacement[i] = oscillator.u;
    response.velocity[i] = oscillator.v;
    response.absolute_acceleration[i] = oscillator.absolute_acceleration();
  }
  return response;
}

ResponseSpectrum response_spectrum(const Motion& motion, std::span<const double> periods, double damping) {
  check(motion);
  check_damping(damping);
  const double pga = peaks(motion).acceleration;
  ResponseSpectrum spectrum;
  for (const double period : periods) {
    // An oscillator of a shorter period is rigid for any motion with this step, and would need more than 4000
    // parts of each step.
    const double shortest = motion.dt / 100;
    if (period != 0 && !(period >= shortest && std::isfinite(period)))
      throw UserError(
          "", fmt::format("a period of the spectrum is {} s; give 0 or at least {:.3g} s", period, shortest));
    const double w = 2 * std::numbers::pi / period;
    const PeakResponse peak = period == 0 ? PeakResponse{0, 0, pga} : peak_response(motion, period, damping);
    spectrum.period.push_back(period);
    spectrum.displacement.push_back(peak.displacement);
    spectrum.velocity.push_back(peak.velocity);
    spectrum.pseudo_acceleration.push_back(period == 0 ? pga : w * w * peak.displacement);
    spectrum.absolute_acceleration.push_back(peak.absolute_acceleration);
  }
  return spectrum;
}

std::vector<double> logarithmic_periods(double first, double last, int count) {
  require_positive(first, "shortest period");
  if (!(last > first) || !std::isfinite(last))
    throw UserError("", fmt::format("periods from {} s to {} s are not a band; give an end above its begin",
                                    first, last));
  if (count < 2) throw UserError("", fmt::format("{} periods are asked for; give at least 2", count));
  std::vector<double> periods(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    periods[static_cast<std::size_t>(i)] =
        first * std::pow(last / first, static_cast<double>(i) / (count - 1));
  return periods;
}

}  // namespace adit::motion
