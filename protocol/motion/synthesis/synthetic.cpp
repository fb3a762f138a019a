#include "protocol/motion/synthesis/synthetic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/motion/fourier.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/random.hpp"
#include "protocol/motion/spectra/response.hpp"

namespace adit::motion {
namespace {

using protocol::UserError;

constexpr double kDamping = 0.05;  // damping ratio of the oscillators for which target spectra are defined
// The motion contains frequencies a little beyond the ends of the band, because an oscillator at an end of
// the band also responds to neighbouring frequencies.
constexpr double kOverhang = 1.25;

double envelope_at(const Envelope& envelope, double t) {
  if (t < envelope.rise) return (t / envelope.rise) * (t / envelope.rise);
  if (t <= envelope.decay) return 1;
  return std::exp(-envelope.rate * (t - envelope.decay));
}

void check_request(const SyntheticRequest& request) {
  require_positive(request.dt, "time step of the synthetic motion");
  require_positive(request.duration, "duration of the synthetic motion");
  if (request.duration / request.dt > 1e7)
    throw UserError(
        "", "the synthetic motion has more than 1e7 values; give a longer step or a shorter duration");
  if (!(request.shortest_period >= 4 * request.dt))
    throw UserError(
        "",
        fmt::format("the band begins at a period of {:.6g} s; at steps of {:.6g} s give at least {:.6g} s",
                    request.shortest_period, request.dt, 4 * request.dt));
  if (!(request.longest_period > request.shortest_period && request.longest_period <= request.duration / 3))
    throw UserError(
        "", fmt::format("the band ends at a period of {:.6g} s; give more than {:.6g} s and at most a third "
                        "of the duration, {:.6g} s",
                        request.longest_period, request.shortest_period, request.duration / 3));
  const auto& [rise, decay, rate] = request.envelope;
  if (!(rise >= 0 && decay >= rise && decay <= request.duration && rate >= 0 && std::isfinite(rate)))
    throw UserError(
        "", fmt::format("the envelope rises to {:.6g} s and decays from {:.6g} s at {:.6g} per second; give "
                        "0 <= rise <= decay <= duration and a rate of 0 or more",
                        rise, decay, rate));
  if (request.iterations < 1)
    throw UserError("", fmt::format("{} iterations are asked for; give at least 1", request.iterations));
  if (!request.target) throw UserError("", "the synthetic motion has no target spectrum; give one");
}

// The value at `x` on the straight lines through the points (xs, ys), constant beyond their ends.
double interpolated(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto after = std::ranges::upper_bound(xs, x);
  if (after == xs.begin()) return ys.front();
  if (after == xs.end()) return ys.back();
  const auto i = static_cast<std::size_t>(after - xs.begin());
  const double share = (x - xs[i - 1]) / (xs[i] - xs[i - 1]);
  return ys[i - 1] + share * (ys[i] - ys[i - 1]);
}

class Synthesis {
 public:
  explicit Synthesis(const SyntheticRequest& request)
      : request_(request),
        count_(static_cast<std::size_t>(std::llround(request.duration / request.dt)) + 1),
        periods_(logarithmic_periods(request.shortest_period, request.longest_period, kControlPeriods)),
        spectrum_(std::bit_ceil(count_) / 2 + 1) {
    for (const double period : periods_) {
      target_.push_back(request.target(period));
      require_positive(target_.back(), fmt::format("target spectrum at {:.6g} s", period));
      logarithms_.push_back(std::log(period));
    }
    // An oscillator responds to a band of components whose number grows with its own frequency f. Their
    // amplitudes must fall as 1/sqrt(f) for the same response.
    Random random(request.seed);
    for (std::size_t k = 1; k + 1 < spectrum_.size(); ++k) {
      const double f = frequency(k), phase = 2 * std::numbers::pi * random.uniform();
      if (f * request.longest_period * kOverhang < 1 || f * request.shortest_period > kOverhang) continue;
      spectrum_[k] = std::polar(request.target(1 / f) / std::sqrt(f), phase);
    }
  }

  Motion motion() const {
    Motion motion{request_.dt, inverse_transform(spectrum_)};
    motion.acceleration.resize(count_);
    for (std::size_t i = 0; i < count_; ++i)
      motion.acceleration[i] *= envelope_at(request_.envelope, static_cast<double>(i) * request_.dt);
    return baseline_corrected(motion);
  }

  // Ratio of target to response at the control periods.
  std::vector<double> ratios(const Motion& motion) const {
    std::vector<double> ratios = response_spectrum(motion, periods_, kDamping).pseudo_acceleration;
    for (std::size_t i = 0; i < ratios.size(); ++i) ratios[i] = target_[i] / ratios[i];
    return ratios;
  }

  void correct(const std::vector<double>& ratios) {
    for (std::size_t k = 1; k < spectrum_.size(); ++k)
      spectrum_[k] *= interpolated(logarithms_, ratios, -std::log(frequency(k)));
  }

 private:
  double frequency(std::size_t k) const {
    return static_cast<double>(k) / (2 * static_cast<double>(spectrum_.size() - 1) * request_.dt);
  }

  const SyntheticRequest& request_;
  std::size_t count_;
  std::vector<double> periods_, logarithms_, target_;
  std::vector<std::complex<double>> spectrum_;
};

}  // namespace

SyntheticMotion synthesize(const SyntheticRequest& request) {
  check_request(request);
  Synthesis synthesis(request);
  SyntheticMotion best{{}, std::numeric_limits<double>::infinity(), 0, 0};
  for (int iteration = 0; iteration <= request.iterations; ++iteration) {
    Motion motion = synthesis.motion();
    const std::vector<double> ratios = synthesis.ratios(motion);
    double sum = 0, largest = 0;
    for (const double ratio : ratios) {
      const double misfit = std::abs(1 / ratio - 1);
      sum += misfit;
      largest = std::max(largest, misfit);
    }
    const double mean = sum / kControlPeriods;
    if (mean < best.mean_misfit) best = {std::move(motion), mean, largest, iteration};
    synthesis.correct(ratios);
  }
  return best;
}

}  // namespace adit::motion
