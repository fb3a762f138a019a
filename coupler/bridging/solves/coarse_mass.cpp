#include "coupler/bridging/solves/coarse_mass.hpp"

#include <chrono>
#include <cmath>

namespace adit::coupler {
namespace {

bool same_in_x_and_y(std::span<const double> interleaved) {
  for (std::size_t i = 0; i < interleaved.size(); i += 2)
    if (interleaved[i] != interleaved[i + 1]) return false;
  return true;
}

constexpr int kFixed = -1;  // marks a point without a row in the matrix

// The lower triangle of the matrix for one direction, without the fixed points.
Eigen::SparseMatrix<double> assemble(const Interpolation& coarse, std::span<const double> fine_masses,
                                     std::span<const double> diagonal, int direction,
                                     const std::vector<int>& rows, int size) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t j = 0; j < rows.size(); ++j)
    if (rows[j] != kFixed) entries.emplace_back(rows[j], rows[j], diagonal[2 * j + direction]);
  for (std::size_t k = 0; k < coarse.coupling_points(); ++k) {
    const auto columns = coarse.columns(k);
    const auto values = coarse.values(k);
    for (std::size_t a = 0; a < columns.size(); ++a)
      for (std::size_t b = 0; b < columns.size(); ++b) {
        const int row = rows[columns[a]], column = rows[columns[b]];
        // Entries of one place are summed by setFromTriplets(), and the factor reads the lower triangle only.
        if (column != kFixed && row >= column)
          entries.emplace_back(row, column, values[a] * fine_masses[2 * k + direction] * values[b]);
      }
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

std::vector<double> masses_of(const Interpolation& coarse) {
  std::vector<double> masses;
  // A prescribed motion has the inverse mass 0, and 1/0 is the infinite mass that stands for it.
  masses.reserve(coarse.inverse_masses().size());
  for (const double inverse : coarse.inverse_masses()) masses.push_back(1.0 / inverse);
  return masses;
}

CoarseMass::CoarseMass(const Interpolation& coarse, std::span<const double> fine_masses,
                       std::span<const double> diagonal) {
  const auto start = std::chrono::steady_clock::now();
  if (same_in_x_and_y(fine_masses) && same_in_x_and_y(diagonal))
    both_ = factor<2>(coarse, fine_masses, diagonal, 0);
  else
    for (const int direction : {0, 1}) each_.push_back(factor<1>(coarse, fine_masses, diagonal, direction));
  cost_.factor_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <int Sides>
CoarseMass::Directions<Sides> CoarseMass::factor(const Interpolation& coarse,
                                                 std::span<const double> fine_masses,
                                                 std::span<const double> diagonal, int direction) {
  std::vector<int> rows(coarse.own_points(), kFixed);
  std::vector<std::size_t> fixed;
  int size = 0;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    if (std::isfinite(diagonal[2 * j + direction]))
      rows[j] = size++;
    else
      fixed.push_back(2 * j + direction);
  }
  Directions<Sides> result{
      .factor = protocol::SymmetricFactor(assemble(coarse, fine_masses, diagonal, direction, rows, size)),
      .own = std::vector<std::size_t>(size),
      .fixed = std::move(fixed),
      .x = Eigen::Array<double, Sides, Eigen::Dynamic>(Sides, size)};
  for (std::size_t j = 0; j < rows.size(); ++j)
    // The values are listed in the factor's own order, so that a solve needs no permutation.
    if (rows[j] != kFixed) result.own[result.factor.place(rows[j])] = 2 * j + direction;
  cost_.factor_bytes += result.factor.bytes();
  cost_.unknowns += Sides * result.own.size();
  return result;
}

template <int Sides>
void CoarseMass::Directions<Sides>::solve(std::span<double> own_values) {
  for (std::size_t place = 0; place < own.size(); ++place)
    for (int side = 0; side < Sides; ++side)
      x(side, static_cast<Eigen::Index>(place)) = own_values[own[place] + side];
  factor.solve(x);
  for (std::size_t place = 0; place < own.size(); ++place)
    for (int side = 0; side < Sides; ++side)
      own_values[own[place] + side] = x(side, static_cast<Eigen::Index>(place));
  for (const std::size_t value : fixed)
    for (int side = 0; side < Sides; ++side) own_values[value + side] = 0;
}

void CoarseMass::solve(std::span<double> own) {
  if (both_) both_->solve(own);
  for (Directions<1>& direction : each_) direction.solve(own);
}

}  // namespace adit::coupler
