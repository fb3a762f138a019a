// Random interfaces: a coarse side whose velocities are interpolated at the coupling points, and a fine side
// that has a point of its own at each of them.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "coupler/bridging/interpolation.hpp"

namespace adit::test {

struct RandomInterface {
  coupler::Interpolation coarse;
  std::vector<double> fine_masses;  // one pair for each coupling point
  std::vector<double> decay;        // one share for each coupling point
};

// Rows of N have four entries that sum to 1 (some negative: a little outside). Masses spread over `decades`
// powers of ten, some coarse points are held in y, a share of 0 to 1 decays.
inline RandomInterface random_interface(unsigned seed, double decades) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const std::size_t coarse_points = 4 + seed % 9, points = 3 * coarse_points + seed % 31;
  const auto mass = [&] { return std::pow(10.0, decades * (unit(random) - 0.5)); };
  std::vector<std::uint32_t> row_starts = {0}, columns;
  std::vector<double> values, inverse_masses, fine_masses, decay;
  for (std::size_t k = 0; k < points; ++k) {
    // Coupling points go along the coarse points, as they do in a grid: every coarse point is seen.
    const std::size_t first = std::min(k * (coarse_points - 3) / points, coarse_points - 4);
    std::vector<double> shares(4);
    double sum = 0;
    for (double& share : shares) sum += share = unit(random) + 1e-3;
    for (std::size_t e = 0; e < 4; ++e) {
      columns.push_back(static_cast<std::uint32_t>(first + e));
      values.push_back(shares[e] / sum);
    }
    if (seed % 3 == 0) {
      values[values.size() - 1] += 0.3;
      values[values.size() - 2] -= 0.3;
    }
    row_starts.push_back(static_cast<std::uint32_t>(columns.size()));
    const double m = mass();
    fine_masses.insert(fine_masses.end(), {m, m});
    decay.push_back(unit(random) < 0.2 ? 1.0 : unit(random));
  }
  for (std::size_t j = 0; j < coarse_points; ++j) {
    const double m = mass();
    inverse_masses.insert(inverse_masses.end(), {1 / m, unit(random) < 0.1 ? 0.0 : 1 / m});
  }
  return {{row_starts, columns, values, inverse_masses}, fine_masses, decay};
}

// N as a full matrix, for one direction.
inline Eigen::MatrixXd dense(const coupler::Interpolation& n) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n.coupling_points(), n.own_points());
  for (std::size_t k = 0; k < n.coupling_points(); ++k)
    for (std::size_t e = 0; e < n.columns(k).size(); ++e) matrix(k, n.columns(k)[e]) += n.values(k)[e];
  return matrix;
}

// Every second value of an interleaved vector.
inline Eigen::VectorXd component(std::span<const double> interleaved, int direction) {
  Eigen::VectorXd values(interleaved.size() / 2);
  for (Eigen::Index k = 0; k < values.size(); ++k) values[k] = interleaved[2 * k + direction];
  return values;
}

// One direction of an interface as full matrices.
struct Dense {
  Eigen::MatrixXd n;
  Eigen::VectorXd inverse_coarse, fine;  // 1/M, m
  Dense(const RandomInterface& interface, int direction)
      : n(dense(interface.coarse)),
        inverse_coarse(component(interface.coarse.inverse_masses(), direction)),
        fine(component(interface.fine_masses, direction)) {}
  // A = N M⁻¹ Nᵀ + m⁻¹ as it is written.
  Eigen::MatrixXd system() const {
    Eigen::MatrixXd a = n * inverse_coarse.asDiagonal() * n.transpose();
    a.diagonal() += fine.cwiseInverse();
    return a;
  }
  // Q = N (Nᵀ m N)⁻¹ Nᵀ m, the projection on what the coarse side can carry.
  Eigen::MatrixXd projection() const {
    const Eigen::MatrixXd root =
        fine.cwiseSqrt().asDiagonal() * n;  // its range, in the product of the energy
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(root);
    const Eigen::MatrixXd basis = Eigen::MatrixXd(qr.householderQ()).leftCols(qr.rank());
    return fine.cwiseSqrt().cwiseInverse().asDiagonal() * basis * basis.transpose() *
           fine.cwiseSqrt().asDiagonal();
  }
};

inline std::vector<double> random_vector(unsigned seed, std::size_t size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::vector<double> vector(size);
  for (double& v : vector) v = value(random);
  return vector;
}

}  // namespace adit::test
