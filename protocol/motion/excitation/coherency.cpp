// The coherency of the model, exp(-(drift w d)^2), is the mean of exp(i kappa d) over Gaussian wave numbers
// kappa with variance 2 (drift w)^2. Draw M such wave numbers kappa_m and independent complex Gaussian
// numbers e_m of unit mean square; then the random field R(x) = sum e_m exp(i kappa_m x) / sqrt(M) has this
// coherency. Let U be the spectrum of the given motion, which one station keeps, d_j the distance of station
// j from that one, and gamma_j the coherency of the model at d_j. The motion of station j is
//   U_j = gamma_j U + U sum e_m (exp(i kappa_m d_j) - gamma_j) / sqrt(M),
// so that E[U_j U_k*] = gamma_jk |U|^2. The field is defined at all places, so each station costs the same,
// and its motion does not depend on the other stations.
//
// With independent e_m at every frequency, the second (incoherent) part would spread over the whole duration.
// It is therefore made in segments of time that overlap by half: the motion is multiplied by a window of half
// a sine, and so is the segment's result. The squares of the windows add up to one, so strong shaking stays
// at its time. The noise of a segment has the same mean square all along the segment, and the second window
// halves its energy; a factor of sqrt(2) makes up for that. A segment does not resolve frequencies below 1 /
// kSegment. They are removed from the incoherent part, so that the coherency there is higher than that of the
// model. The difference from the given motion has its baseline corrected, so that all stations end at the
// place where the given motion ends.
#include "protocol/motion/excitation/coherency.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

#include "protocol/motion/fourier.hpp"
#include "protocol/motion/processing/filter.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/random.hpp"

namespace adit::motion {
namespace {

constexpr double kSegment = 5;  // [s]
constexpr int kHighPassOrder = 4;

// Number M of waves at one frequency. The mean coherency is right for any number; that of one draw deviates
// by about 1/sqrt(kWaves) at a single frequency.
constexpr int kWaves = 64;

// (exp(i kappa_m d_j) - gamma_j) / sqrt(M), a row for each station and a column for each wave.
Eigen::MatrixXcd waves_at(std::span<const double> distances, double drift, double frequency, Random& random) {
  const auto stations = static_cast<Eigen::Index>(distances.size());
  Eigen::MatrixXcd waves(stations, kWaves);
  for (Eigen::Index m = 0; m < kWaves; ++m) {
    // kappa = 2 drift w x, where x, the real part of complex_gaussian(), has the variance 1/2.
    const double kappa = 4 * std::numbers::pi * frequency * drift * random.complex_gaussian().real();
    for (Eigen::Index j = 0; j < stations; ++j) {
      const double distance = distances[static_cast<std::size_t>(j)];
      waves(j, m) = (std::polar(1.0, kappa * distance) - luco_wong(drift, frequency, distance)) /
                    std::sqrt(double{kWaves});
    }
  }
  return waves;
}

// The coherent part gamma_j U, for the whole motion at once.
Motion coherent_part(const Motion& motion, double drift, double distance) {
  const std::size_t n = std::bit_ceil(2 * motion.acceleration.size());
  auto spectrum = transform(motion.acceleration, n);
  for (std::size_t k = 0; k < spectrum.size(); ++k)
    spectrum[k] *= luco_wong(drift, static_cast<double>(k) / (static_cast<double>(n) * motion.dt), distance);
  Motion part{motion.dt, inverse_transform(spectrum)};
  part.acceleration.resize(motion.acceleration.size());
  return part;
}

// The incoherent part for all stations, one row for each, before frequencies below 1 / kSegment are removed.
class IncoherentPart {
 public:
  IncoherentPart(const Motion& motion, std::span<const double> distances, double drift, std::uint64_t seed)
      : motion_(motion),
        half_(static_cast<std::ptrdiff_t>(std::bit_ceil(static_cast<std::size_t>(kSegment / motion.dt) + 2)) /
              2),
        random_(seed),
        parts_(distances.size(), Motion{motion.dt, std::vector<double>(motion.acceleration.size())}) {
    for (std::ptrdiff_t k = 0; k < half_; ++k)
      waves_.push_back(waves_at(
          distances, drift, static_cast<double>(k) / (2 * static_cast<double>(half_) * motion.dt), random_));
    for (std::ptrdiff_t begin = -half_; begin < std::ssize(motion.acceleration); begin += half_)
      add_segment(begin);
  }

  std::vector<Motion> take() { return std::move(parts_); }

 private:
  double window(std::ptrdiff_t i) const {
    return std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / (2 * static_cast<double>(half_)));
  }

  void add_segment(std::ptrdiff_t begin) {
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, -begin);
    const std::ptrdiff_t end = std::min(2 * half_, std::ssize(motion_.acceleration) - begin);
    std::vector<double> windowed(2 * static_cast<std::size_t>(half_));
    for (std::ptrdiff_t i = first; i < end; ++i)
      windowed[static_cast<std::size_t>(i)] =
          window(i) * motion_.acceleration[static_cast<std::size_t>(begin + i)];
    const auto spectrum = transform(windowed, windowed.size());

    const auto stations = static_cast<Eigen::Index>(parts_.size());
    // The last column, the Nyquist frequency, stays zero: it has no wave.
    Eigen::MatrixXcd mixed = Eigen::MatrixXcd::Zero(stations, half_ + 1);
    Eigen::VectorXcd noise(kWaves);
    for (std::ptrdiff_t k = 0; k < half_; ++k) {
      for (std::complex<double>& e : noise) e = random_.complex_gaussian();
      mixed.col(k).noalias() = waves_[static_cast<std::size_t>(k)] * noise;
      mixed.col(k) *= std::numbers::sqrt2 * spectrum[static_cast<std::size_t>(k)];
    }
    for (Eigen::Index j = 0; j < stations; ++j) {
      const Eigen::RowVectorXcd row = mixed.row(j);
      const std::vector<double> noise = inverse_transform({row.data(), static_cast<std::size_t>(row.size())});
      auto& values = parts_[static_cast<std::size_t>(j)].acceleration;
      for (std::ptrdiff_t i = first; i < end; ++i)
        values[static_cast<std::size_t>(begin + i)] += window(i) * noise[static_cast<std::size_t>(i)];
    }
  }

  const Motion& motion_;
  std::ptrdiff_t half_;  // half the length of a segment, in steps
  Random random_;
  std::vector<Eigen::MatrixXcd> waves_;  // one matrix for each frequency
  std::vector<Motion> parts_;
};

}  // namespace

double luco_wong(double drift, double frequency, double distance) {
  const double x = drift * 2 * std::numbers::pi * frequency * distance;
  return std::exp(-x * x);
}

std::vector<Motion> incoherent_motions(const Motion& motion, std::span<const double> distances,
                                       std::size_t reference, double drift, std::uint64_t seed) {
  std::vector<double> from_reference;
  for (const double distance : distances) from_reference.push_back(distance - distances[reference]);
  std::vector<Motion> motions = IncoherentPart(motion, from_reference, drift, seed).take();
  for (std::size_t j = 0; j < motions.size(); ++j) {
    const double distance = from_reference[j];
    if (distance == 0) {
      motions[j] = motion;
      continue;
    }
    const Motion incoherent = high_pass(motions[j], 1 / kSegment, kHighPassOrder, Phase::kZero);
    const Motion coherent = coherent_part(motion, drift, distance);
    Motion difference = motion;
    for (std::size_t i = 0; i < motion.acceleration.size(); ++i)
      difference.acceleration[i] =
          coherent.acceleration[i] + incoherent.acceleration[i] - motion.acceleration[i];
    difference = baseline_corrected(difference);
    for (std::size_t i = 0; i < motion.acceleration.size(); ++i)
      motions[j].acceleration[i] = motion.acceleration[i] + difference.acceleration[i];
  }
  return motions;
}

}  // namespace adit::motion
