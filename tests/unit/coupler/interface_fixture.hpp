// Random interfaces: a grid whose coupling points are interpolated, particles that are coupling points.
#pragma once

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "coupler/bridging/interpolation.hpp"

namespace adit::test {

struct RandomInterface {
  coupler::Interpolation grid, particles;
};

// N of the grid: `width` non-negative entries a row that sum to 1. Masses spread over `decades` powers of
// ten.
inline RandomInterface random_interface(unsigned seed, std::size_t points, std::size_t grid_points,
                                        double decades) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto inverse_mass = [&] { return std::pow(10.0, decades * (unit(random) - 0.5)); };
  const std::size_t width = std::min<std::size_t>(4, grid_points);
  wire::Operator grid, particles;
  grid.add_row_starts(0);
  particles.add_row_starts(0);
  for (std::size_t k = 0; k < points; ++k) {
    const std::size_t first = std::uniform_int_distribution<std::size_t>(0, grid_points - width)(random);
    std::vector<double> shares(width);
    double sum = 0;
    for (double& share : shares) sum += share = unit(random) + 1e-3;
    for (std::size_t e = 0; e < width; ++e) {
      grid.add_columns(first + e);
      grid.add_values(shares[e] / sum);
    }
    grid.add_row_starts(width * (k + 1));
    particles.add_columns(k);
    particles.add_values(1.0);
    particles.add_row_starts(k + 1);
    const double inverse = inverse_mass();
    particles.add_inverse_masses(inverse);
    particles.add_inverse_masses(inverse);
  }
  for (std::size_t j = 0; j < grid_points; ++j) {
    const double inverse = inverse_mass();
    grid.add_inverse_masses(inverse);
    grid.add_inverse_masses(unit(random) < 0.1 ? 0.0 : inverse);  // some are held in y
  }
  return {coupler::Interpolation(grid, points, "grid"),
          coupler::Interpolation(particles, points, "particles")};
}

// N as a full matrix, for one direction.
inline Eigen::MatrixXd dense(const coupler::Interpolation& n) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n.coupling_points(), n.own_points());
  for (std::size_t k = 0; k < n.coupling_points(); ++k)
    for (std::size_t e = 0; e < n.columns(k).size(); ++e) matrix(k, n.columns(k)[e]) += n.values(k)[e];
  return matrix;
}

inline Eigen::VectorXd inverse_masses(const coupler::Interpolation& n, int direction) {
  Eigen::VectorXd inverse(n.own_points());
  for (std::size_t j = 0; j < n.own_points(); ++j) inverse[j] = n.inverse_mass(j, direction);
  return inverse;
}

// A = N_C M⁻¹ N_Cᵀ + N_P m⁻¹ N_Pᵀ as it is written.
inline Eigen::MatrixXd system_matrix(const RandomInterface& interface, int direction) {
  const Eigen::MatrixXd grid = dense(interface.grid), particles = dense(interface.particles);
  return grid * inverse_masses(interface.grid, direction).asDiagonal() * grid.transpose() +
         particles * inverse_masses(interface.particles, direction).asDiagonal() * particles.transpose();
}

inline std::vector<double> random_vector(unsigned seed, std::size_t size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::vector<double> vector(size);
  for (double& v : vector) v = value(random);
  return vector;
}

// Every second value of an interleaved vector.
inline Eigen::VectorXd component(const std::vector<double>& interleaved, int direction) {
  Eigen::VectorXd values(interleaved.size() / 2);
  for (Eigen::Index k = 0; k < values.size(); ++k) values[k] = interleaved[2 * k + direction];
  return values;
}

}  // namespace adit::test
