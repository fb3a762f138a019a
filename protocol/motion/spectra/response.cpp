#include "protocol/motion/spectra/response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/motion/measures.hpp"

namespace adit::motion {
namespace {

using protocol::UserError;

// Takes N oscillators side by side over one step h under the acceleration a + s t, 0 <= t <= h. Each waits
// for its own last step only, so that a core has all of them in work at once. The particular solution is
//   u_p = -(a + s t)/w^2 + 2 damping s/w^3,   v_p = -s/w^2.
// The difference from it is a free oscillation, which the matrix (uu_ uv_; vu_ vv_) takes over the step.
template <std::size_t N>
class Oscillators {
 public:
  // The last period stands for those that lack.
  Oscillators(std::span<const double> periods, double damping, double h) : per_h_(1 / h) {
    for (std::size_t k = 0; k < N; ++k) {
      const double w = 2 * std::numbers::pi / periods[std::min(k, periods.size() - 1)];
      flexibility_[k] = 1 / (w * w);
      lag_[k] = 2 * damping * flexibility_[k] / w;
      stiffness_[k] = w * w;
      resistance_[k] = 2 * damping * w;
      const double damped = w * std::sqrt(1 - damping * damping);
      const double decay = std::exp(-damping * w * h), sine = decay * std::sin(damped * h),
                   cosine = decay * std::cos(damped * h);
      uu_[k] = cosine + damping * w / damped * sine;
      uv_[k] = sine / damped;
      vu_[k] = -w * w / damped * sine;
      vv_[k] = cosine - damping * w / damped * sine;
    }
  }

  void step(double a, double a_end) {
    const double slope = (a_end - a) * per_h_;
    for (std::size_t k = 0; k < N; ++k) {
      const double v_forced = -slope * flexibility_[k], lag = slope * lag_[k];
      const double u_free = u[k] + a * flexibility_[k] - lag, v_free = v[k] - v_forced;
      u[k] = uu_[k] * u_free + uv_[k] * v_free - a_end * flexibility_[k] + lag;
      v[k] = vu_[k] * u_free + vv_[k] * v_free + v_forced;
    }
  }

  // The absolute acceleration u'' + a, from the equation of motion.
  double absolute_acceleration(std::size_t k) const { return -resistance_[k] * v[k] - stiffness_[k] * u[k]; }

  std::array<double, N> u{}, v{};

 private:
  double per_h_;
  std::array<double, N> flexibility_, lag_, stiffness_,
      resistance_;  // 1/w^2, 2 damping/w^3, w^2, 2 damping w
  std::array<double, N> uu_, uv_, vu_, vv_;
};

void check_damping(double damping) {
  if (!(damping >= 0 && damping < 1))
    throw UserError("", fmt::format("the damping ratio is {}; give one from 0 to below 1", damping));
}

struct PeakResponse {
  double displacement = 0, velocity = 0, absolute_acceleration = 0;
};

// Parts of a step, for the peaks of a short period.
int parts_of_a_step(const Motion& motion, double period) {
  return std::max(1, static_cast<int>(std::ceil(40 * motion.dt / period)));
}

constexpr std::size_t kSideBySide = 16;

// Of at most so many periods, whose steps have as many parts.
std::array<PeakResponse, kSideBySide> peak_responses(const Motion& motion, std::span<const double> periods,
                                                     double damping) {
  const int parts = parts_of_a_step(motion, periods.front());
  Oscillators<kSideBySide> oscillators(periods, damping, motion.dt / parts);
  std::array<double, kSideBySide> displacement{}, velocity{}, acceleration{};
  for (std::size_t i = 1; i < motion.acceleration.size(); ++i) {
    const double a = motion.acceleration[i - 1], rise = (motion.acceleration[i] - a) / parts;
    for (int part = 0; part < parts; ++part) {
      oscillators.step(a + part * rise, a + (part + 1) * rise);
      for (std::size_t k = 0; k < kSideBySide; ++k) {
        displacement[k] = std::max(displacement[k], std::abs(oscillators.u[k]));
        velocity[k] = std::max(velocity[k], std::abs(oscillators.v[k]));
        acceleration[k] = std::max(acceleration[k], std::abs(oscillators.absolute_acceleration(k)));
      }
    }
  }
  std::array<PeakResponse, kSideBySide> peaks;
  for (std::size_t k = 0; k < kSideBySide; ++k) peaks[k] = {displacement[k], velocity[k], acceleration[k]};
  return peaks;
}

// One a period above 0.
std::vector<PeakResponse> all_peak_responses(const Motion& motion, std::span<const double> periods,
                                             double damping) {
  std::vector<PeakResponse> peaks;
  while (peaks.size() < periods.size()) {
    const auto rest = periods.subspan(peaks.size());
    const int parts = parts_of_a_step(motion, rest.front());
    std::size_t count = 1;
    while (count < std::min(rest.size(), kSideBySide) && parts_of_a_step(motion, rest[count]) == parts)
      ++count;
    const auto some = peak_responses(motion, rest.first(count), damping);
    peaks.insert(peaks.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return peaks;
}

}  // namespace

OscillatorResponse oscillator_response(const Motion& motion, double period, double damping) {
  check(motion);
  require_positive(period, "period of the oscillator");
  check_damping(damping);
  const std::size_t count = motion.acceleration.size();
  OscillatorResponse response{std::vector<double>(count), std::vector<double>(count),
                              std::vector<double>(count)};
  Oscillators<1> oscillator({&period, 1}, damping, motion.dt);
  for (std::size_t i = 1; i < count; ++i) {
    oscillator.step(motion.acceleration[i - 1], motion.acceleration[i]);
    response.displacement[i] = oscillator.u[0];
    response.velocity[i] = oscillator.v[0];
    response.absolute_acceleration[i] = oscillator.absolute_acceleration(0);
  }
  return response;
}

ResponseSpectrum response_spectrum(const Motion& motion, std::span<const double> periods, double damping) {
  check(motion);
  check_damping(damping);
  // An oscillator of a shorter period is rigid for any motion with this step, and would need more than 4000
  // parts of each step.
  const double shortest = motion.dt / 100;
  std::vector<double> moving;
  for (const double period : periods) {
    if (period != 0 && !(period >= shortest && std::isfinite(period)))
      throw UserError(
          "", fmt::format("a period of the spectrum is {} s; give 0 or at least {:.3g} s", period, shortest));
    if (period != 0) moving.push_back(period);
  }
  const std::vector<PeakResponse> responses = all_peak_responses(motion, moving, damping);
  const double pga = peaks(motion).acceleration;
  ResponseSpectrum spectrum;
  auto next = responses.begin();
  for (const double period : periods) {
    const double w = 2 * std::numbers::pi / period;
    const PeakResponse peak = period == 0 ? PeakResponse{0, 0, pga} : *next++;
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
