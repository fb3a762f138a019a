#include "coupler/bridging/consistent.hpp"

#include <stdexcept>

namespace adit::coupler {

ConsistentSolve::ConsistentSolve(const Interpolation& continuum, const Interpolation& particles)
    : interpolation_(continuum),
      particle_masses_(2 * continuum.coupling_points()),
      on_grid_(2 * continuum.own_points()) {
  for (std::size_t i = 0; i < particle_masses_.size(); ++i)
    particle_masses_[i] = 1.0 / particles.inverse_mass(particles.columns(i / 2)[0], static_cast<int>(i % 2));
  for (const int direction : {0, 1}) factor(direction);
}

void ConsistentSolve::factor(int direction) {
  Direction& d = directions_[direction];
  constexpr int kPrescribed = -1;
  std::vector<int> numbers(interpolation_.own_points(), kPrescribed);
  for (std::size_t j = 0; j < numbers.size(); ++j)
    if (interpolation_.inverse_mass(j, direction) > 0) {
      numbers[j] = static_cast<int>(d.free.size());
      d.free.push_back(j);
    }

  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < d.free.size(); ++i) {
    const int number = static_cast<int>(i);
    entries.emplace_back(number, number, 1.0 / interpolation_.inverse_mass(d.free[i], direction));
  }
  for (std::size_t k = 0; k < interpolation_.coupling_points(); ++k) {
    const auto columns = interpolation_.columns(k);
    const auto values = interpolation_.values(k);
    const double mass = particle_masses_[2 * k + direction];
    for (std::size_t a = 0; a < columns.size(); ++a)
      for (std::size_t b = 0; b < columns.size(); ++b)
        if (numbers[columns[a]] != kPrescribed && numbers[columns[b]] != kPrescribed)
          entries.emplace_back(numbers[columns[a]], numbers[columns[b]], values[a] * mass * values[b]);
  }
  const auto size = static_cast<Eigen::Index>(d.free.size());
  Eigen::SparseMatrix<double> masses(size, size);
  masses.setFromTriplets(entries.begin(), entries.end());
  d.factor.compute(masses);
  if (d.factor.info() != Eigen::Success)
    throw std::logic_error("the interface's mass matrix could not be factored");
  d.right_side.resize(size);
  d.correction.resize(size);
}

void ConsistentSolve::solve(std::span<const double> gap, std::span<double> multipliers) {
  for (std::size_t i = 0; i < gap.size(); ++i) multipliers[i] = particle_masses_[i] * gap[i];
  interpolation_.gather(multipliers, on_grid_);
  for (const int direction : {0, 1}) {
    Direction& d = directions_[direction];
    for (std::size_t i = 0; i < d.free.size(); ++i) d.right_side[i] = on_grid_[2 * d.free[i] + direction];
    d.correction = d.factor.solve(d.right_side);
    for (std::size_t j = direction; j < on_grid_.size(); j += 2) on_grid_[j] = 0;
    for (std::size_t i = 0; i < d.free.size(); ++i) on_grid_[2 * d.free[i] + direction] = d.correction[i];
  }
  interpolation_.interpolate(on_grid_, multipliers);
  for (std::size_t i = 0; i < gap.size(); ++i)
    multipliers[i] = particle_masses_[i] * (gap[i] - multipliers[i]);
}

}  // namespace adit::coupler
