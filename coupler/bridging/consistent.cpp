#include "coupler/bridging/consistent.hpp"

#include <stdexcept>

namespace adit::coupler {
namespace {

// Places of the grid points that are free in this direction; -1 where the motion is prescribed.
std::vector<int> number_free_points(const Interpolation& grid, int direction) {
  std::vector<int> numbers(grid.own_points(), -1);
  int count = 0;
  for (std::size_t j = 0; j < grid.own_points(); ++j)
    if (grid.inverse_mass(j, direction) > 0) numbers[j] = count++;
  return numbers;
}

}  // namespace

ConsistentSolve::ConsistentSolve(const Interpolation& continuum, const Interpolation& particles) {
  const auto points = static_cast<Eigen::Index>(continuum.coupling_points());
  for (int direction = 0; direction < 2; ++direction) {
    Component& c = components_[direction];
    const std::vector<int> numbers = number_free_points(continuum, direction);
    const Eigen::Index free = numbers.size() - std::count(numbers.begin(), numbers.end(), -1);

    std::vector<Eigen::Triplet<double>> entries;
    c.particle_masses.resize(points);
    for (Eigen::Index k = 0; k < points; ++k) {
      c.particle_masses[k] = 1.0 / particles.inverse_mass(particles.columns(k)[0], direction);
      for (std::size_t e = 0; e < continuum.columns(k).size(); ++e)
        if (const int j = numbers[continuum.columns(k)[e]]; j >= 0)
          entries.emplace_back(k, j, continuum.values(k)[e]);
    }
    c.interpolation.resize(points, free);
    c.interpolation.setFromTriplets(entries.begin(), entries.end());

    entries.clear();
    for (std::size_t j = 0; j < numbers.size(); ++j)
      if (numbers[j] >= 0)
        entries.emplace_back(numbers[j], numbers[j], 1.0 / continuum.inverse_mass(j, direction));
    Eigen::SparseMatrix<double> masses(free, free);
    masses.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> n = c.interpolation;
    masses += Eigen::SparseMatrix<double>(n.transpose() * c.particle_masses.asDiagonal() * n);
    c.factor.compute(masses);
    if (c.factor.info() != Eigen::Success)
      throw std::logic_error("the interface's mass matrix could not be factored");

    for (Eigen::VectorXd* vector : {&c.gap, &c.weighted_gap, &c.multipliers}) vector->resize(points);
    for (Eigen::VectorXd* vector : {&c.right_side, &c.grid_correction}) vector->resize(free);
  }
}

void ConsistentSolve::solve(std::span<const double> gap, std::span<double> multipliers) {
  const auto points = static_cast<Eigen::Index>(gap.size() / 2);
  for (int direction = 0; direction < 2; ++direction) {
    Component& c = components_[direction];
    for (Eigen::Index k = 0; k < points; ++k) c.gap[k] = gap[2 * k + direction];
    c.weighted_gap = c.particle_masses.cwiseProduct(c.gap);
    c.right_side.noalias() = c.interpolation.transpose() * c.weighted_gap;
    c.grid_correction = c.factor.solve(c.right_side);
    c.multipliers = c.gap;
    c.multipliers.noalias() -= c.interpolation * c.grid_correction;
    for (Eigen::Index k = 0; k < points; ++k)
      multipliers[2 * k + direction] = c.particle_masses[k] * c.multipliers[k];
  }
}

}  // namespace adit::coupler
