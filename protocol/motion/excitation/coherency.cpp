// The model's coherency exp(-(drift w d)^2) is the mean of exp(i kappa d) over Gaussian wave numbers kappa of
// variance 2 (drift w)^2: the field R(x) = sum e_m exp(i kappa_m x) / sqrt(M), kappa_m drawn so and e_m
// independent complex Gaussian numbers of unit mean square, has it. With U the spectrum of the given motion,
// gamma_j the coherency wanted with the station that keeps U, d_j the distance from it, the others have
//   U_j = gamma_j U + U sum e_m (exp(i kappa_m d_j) - gamma_j) / sqrt(M).
// Then E[U_j U_k*] = gamma_jk |U|^2. The field is that of all places: more stations see more of it, and it
// costs each of them the same.
//
// Independent e_m at every frequency spread the second part over the whole duration. It is therefore made in
// segments of time that overlap by half, from the motion under a window of half a sine and put back under the
// same window: the squares of the windows add up to one, so the shaking keeps its place. A segment's noise
// has the same mean square all along it, and the second window halves its energy: hence the factor sqrt(2).
// What a segment cannot resolve, below 1 / kSegment, is taken out of the noise: coherency there is higher
// than the model's. The difference from the given motion has its baseline corrected: all stations end where
// it ends.
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

// Waves that make up the field at one frequency. The coherency holds in the mean for any number; one draw is
// off it by 1/sqrt(kWaves) at a single frequency.
constexpr int kWaves = 64;

// (exp(i kappa_m d_j) - gamma_j) / sqrt(M), a row a station, a column a wave.
Eigen::MatrixXcd waves_at(std::span<const double> distances, double drift, double frequency, Random& random) {
  const auto stations = static_cast<Eigen::Index>(distances.size());
  Eigen::MatrixXcd waves(stations, kWaves);
  for (Eigen::Index m = 0; m < kWaves; ++m) {
    // The real part has a variance of one half.
    const double kappa = 4 * std::numbers::pi * frequency * drift * random.complex_gaussian().real();
    for (Eigen::Index j = 0; j < stations; ++j) {
      const double distance = distances[static_cast<std::size_t>(j)];
      waves(j, m) = (std::polar(1.0, kappa * distance) - luco_wong(drift, frequency, distance)) /
                    std::sqrt(double{kWaves});
    }
  }
  return waves;
}

// gamma_j U, for the whole motion at once.
Motion coherent_part(const Motion& motion, double drift, double distance) {
  const std::size_t n = std::bit_ceil(2 * motion.acceleration.size());
  auto spectrum = transform(motion.acceleration, n);
  for (std::size_t k = 0; k < spectrum.size(); ++k)
    spectrum[k] *= luco_wong(drift, static_cast<double>(k) / (static_cast<double>(n) * motion.dt), distance);
  Motion part{motion.dt, inverse_transform(spectrum)};
  part.acceleration.resize(motion.acceleration.size());
  return part;
}

// The second part for all stations, one row a station, before the high pass.
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
    Eigen::MatrixXcd mixed = Eigen::MatrixXcd::Zero(stations, half_ + 1);  // its last column stays: no wave
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
  std::ptrdiff_t half_;  // of a segment, in steps
  Random random_;
  std::vector<Eigen::MatrixXcd> waves_;  // one a frequency
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
