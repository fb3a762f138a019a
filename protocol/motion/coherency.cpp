// With U the spectrum of the given motion, gamma_jk the coherency wanted between stations j and k, and 0 the
// station that keeps U, the spectra of the others are
//   U_j = gamma_j0 U + U sum_k L_jk e_k,   L L^T = gamma_jk - gamma_j0 gamma_k0,
// e_k independent complex Gaussian numbers of unit mean square. Then E[U_j U_k*] = gamma_jk |U|^2.
//
// Independent e_k at every frequency spread the second part over the whole duration. It is therefore made in
// segments of time that overlap by half, from the motion under a window of half a sine and put back under the
// same window: the squares of the windows add up to one, so the shaking keeps its place. A segment's noise
// has the same mean square all along it, and the second window halves its energy: hence the factor sqrt(2).
// What a segment cannot resolve, below 1 / kSegment, is taken out of the noise: coherency there is higher
// than the model's. The difference from the given motion has its baseline corrected: all stations end where
// it ends.
#include "protocol/motion/coherency.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

#include "protocol/motion/filter.hpp"
#include "protocol/motion/fourier.hpp"
#include "protocol/motion/processing.hpp"
#include "protocol/motion/random.hpp"

namespace adit::motion {
namespace {

constexpr double kSegment = 5;  // [s]
constexpr int kHighPassOrder = 4;

// A factor L of the conditional covariance of the stations at one frequency. Neighbouring stations make it
// singular to working precision, so the factorization pivots and takes what is left below zero for zero.
Eigen::MatrixXd conditional_factor(std::span<const double> distances, std::size_t reference, double drift,
                                   double frequency) {
  const auto n = static_cast<Eigen::Index>(distances.size());
  const Eigen::Map<const Eigen::VectorXd> place(distances.data(), n);
  Eigen::MatrixXd gamma(n, n);
  for (Eigen::Index k = 0; k < n; ++k)
    for (Eigen::Index j = 0; j <= k; ++j)
      gamma(j, k) = gamma(k, j) = luco_wong(drift, frequency, place[j] - place[k]);
  const Eigen::VectorXd given = gamma.col(static_cast<Eigen::Index>(reference));
  const Eigen::MatrixXd covariance = gamma - given * given.transpose();
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(covariance);
  const Eigen::VectorXd roots = ldlt.vectorD().cwiseMax(0).cwiseSqrt();
  const Eigen::MatrixXd lower = ldlt.matrixL();
  return ldlt.transpositionsP().transpose() * (lower * roots.asDiagonal());
}

// gamma_j0 U, for the whole motion at once.
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
  IncoherentPart(const Motion& motion, std::span<const double> distances, std::size_t reference, double drift,
                 std::uint64_t seed)
      : motion_(motion),
        half_(static_cast<std::ptrdiff_t>(std::bit_ceil(static_cast<std::size_t>(kSegment / motion.dt) + 2)) /
              2),
        random_(seed),
        parts_(distances.size(), Motion{motion.dt, std::vector<double>(motion.acceleration.size())}) {
    for (std::ptrdiff_t k = 0; k <= half_; ++k)
      factors_.push_back(
          conditional_factor(distances, reference, drift,
                             static_cast<double>(k) / (2 * static_cast<double>(half_) * motion.dt)));
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
    Eigen::MatrixXcd mixed(stations, half_ + 1);
    Eigen::MatrixX2d noise(stations, 2);
    for (std::ptrdiff_t k = 0; k <= half_; ++k) {
      for (Eigen::Index j = 0; j < stations; ++j) {
        const std::complex<double> e = random_.complex_gaussian();
        // The first and the last value of a real series' spectrum are real.
        const bool real = k == 0 || k == half_;
        noise.row(j) << (real ? std::numbers::sqrt2 * e.real() : e.real()), (real ? 0 : e.imag());
      }
      const Eigen::MatrixX2d coloured = factors_[static_cast<std::size_t>(k)] * noise;
      mixed.col(k).real() = coloured.col(0);
      mixed.col(k).imag() = coloured.col(1);
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
  std::vector<Eigen::MatrixXd> factors_;  // one a frequency
  std::vector<Motion> parts_;
};

}  // namespace

double luco_wong(double drift, double frequency, double distance) {
  const double x = drift * 2 * std::numbers::pi * frequency * distance;
  return std::exp(-x * x);
}

std::vector<Motion> incoherent_motions(const Motion& motion, std::span<const double> distances,
                                       std::size_t reference, double drift, std::uint64_t seed) {
  std::vector<Motion> motions = IncoherentPart(motion, distances, reference, drift, seed).take();
  for (std::size_t j = 0; j < motions.size(); ++j) {
    const double distance = distances[j] - distances[reference];
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
