#include "protocol/motion/spectra/transfer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/motion/measures.hpp"

namespace adit::motion {
namespace {

constexpr double kBandwidth = 40;

// Beyond this many zeros on either side the window is below 2e-5 and is not summed.
constexpr double kLobes = 5;

// Number of spectral lines from 0 to the lowest frequency. Half the window's width there, a factor of 1.06,
// then contains three lines.
constexpr double kLinesBelowTheFirst = 50;

// The motion padded with zeros to a duration [s].
Motion lengthened(Motion motion, double duration) {
  check(motion);
  const double count = std::ceil(duration / motion.dt);
  if (count > static_cast<double>(motion.acceleration.size()))
    motion.acceleration.resize(static_cast<std::size_t>(count), 0.0);
  return motion;
}

double window(double f, double centre) {
  const double x = kBandwidth * std::log10(f / centre);
  return x == 0 ? 1 : std::pow(std::sin(x) / x, 4);
}

}  // namespace

std::vector<double> smoothed_amplitude(const Motion& motion, std::span<const double> frequencies) {
  for (const double f : frequencies) require_positive(f, "frequency of the smoothed spectrum");
  if (frequencies.empty()) return {};
  const FourierSpectrum spectrum =
      fourier_spectrum(lengthened(motion, kLinesBelowTheFirst / std::ranges::min(frequencies)));
  const double step = spectrum.frequency[1], reach = std::pow(10, kLobes * std::numbers::pi / kBandwidth);
  const std::size_t last = spectrum.frequency.size() - 1;
  std::vector<double> smooth;
  for (const double centre : frequencies) {
    const auto begin = static_cast<std::size_t>(std::ceil(centre / reach / step));
    const auto end = std::min(last, static_cast<std::size_t>(centre * reach / step));
    double sum = 0, weights = 0;
    for (std::size_t k = begin; k <= end; ++k) {
      const double weight = window(spectrum.frequency[k], centre);
      sum += weight * spectrum.amplitude[k] * spectrum.amplitude[k];
      weights += weight;
    }
    smooth.push_back(std::sqrt(sum / weights));
  }
  return smooth;
}

std::vector<double> transfer_function(const Motion& from, const Motion& to,
                                      std::span<const double> frequencies) {
  if (from.dt != to.dt || from.acceleration.size() != to.acceleration.size())
    throw protocol::UserError(
        "",
        fmt::format(
            "the motions have {} values at {} s and {} values at {} s; a transfer function needs the same",
            from.acceleration.size(), from.dt, to.acceleration.size(), to.dt));
  const std::vector<double> below = smoothed_amplitude(from, frequencies);
  std::vector<double> ratio = smoothed_amplitude(to, frequencies);
  for (std::size_t k = 0; k < ratio.size(); ++k) ratio[k] /= below[k];
  return ratio;
}

}  // namespace adit::motion
