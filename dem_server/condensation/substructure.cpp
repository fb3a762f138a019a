#include "dem_server/condensation/substructure.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace adit::dem {
namespace {

constexpr int kTogether = 8;  // right-hand sides, at most

// N for x and y of each coupling point and master.
Eigen::SparseMatrix<double> both_components(const protocol::SparseRows& rows, std::size_t masters) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < rows.rows(); ++k)
    for (std::size_t e = 0; e < rows.columns(k).size(); ++e)
      for (int component = 0; component < 2; ++component)
        entries.emplace_back(static_cast<int>(2 * k) + component,
                             2 * static_cast<int>(rows.columns(k)[e]) + component, rows.values(k)[e]);
  Eigen::SparseMatrix<double> both(static_cast<Eigen::Index>(2 * rows.rows()),
                                   static_cast<Eigen::Index>(2 * masters));
  both.setFromTriplets(entries.begin(), entries.end());
  return both;
}

}  // namespace

Substructure::Substructure(const Tangent& tangent, std::vector<double> masses,
                           std::span<const std::uint32_t> tied, const protocol::SparseRows& ties,
                           std::size_t masters)
    : stiffness_(tangent.stiffness),
      masses_(Eigen::Map<const Eigen::VectorXd>(masses.data(), static_cast<Eigen::Index>(masses.size()))),
      forces_(Eigen::Map<const Eigen::VectorXd>(tangent.forces.data(),
                                                static_cast<Eigen::Index>(tangent.forces.size()))),
      tied_(tied.begin(), tied.end()),
      ties_(both_components(ties, masters)),
      masters_(masters) {
  std::vector<int> place(masses.size(), 0);  // among the freedoms i, -1 of others
  for (const std::uint32_t i : tied_) place[kFreedoms * i] = place[kFreedoms * i + 1] = -1;
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (place[k] < 0 || !(masses[k] > 0)) {
      place[k] = -1;
      continue;
    }
    place[k] = static_cast<int>(free_.size());
    free_.push_back(static_cast<Eigen::Index>(k));
  }
  std::vector<Eigen::Triplet<double>> lower;
  for (const Eigen::Index column : free_)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness_, column); entry; ++entry) {
      const int row = place[static_cast<std::size_t>(entry.row())],
                of = place[static_cast<std::size_t>(column)];
      if (row >= of) lower.emplace_back(row, of, entry.value());
    }
  std::vector<Eigen::Triplet<double>> held;
  for (std::size_t k = 0; k < tied_.size(); ++k)
    for (int component = 0; component < 2; ++component)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(
               stiffness_, static_cast<Eigen::Index>(kFreedoms * tied_[k]) + component);
           entry; ++entry)
        held.emplace_back(static_cast<int>(entry.row()), static_cast<int>(2 * k) + component, entry.value());
  held_.resize(stiffness_.rows(), static_cast<Eigen::Index>(2 * tied_.size()));
  held_.setFromTriplets(held.begin(), held.end());
  const auto size = static_cast<Eigen::Index>(free_.size());
  Eigen::SparseMatrix<double> inner(size, size);
  inner.setFromTriplets(lower.begin(), lower.end());
  try {
    factor_.emplace(inner);
  } catch (const std::logic_error&) {
    throw NotHeld{};
  }
}

// So many right-hand sides pass through the factor together.
template <int kSides>
void Substructure::solve_inside(const Columns& rows, Eigen::Index begin, Columns& solution) const {
  Eigen::Array<double, kSides, Eigen::Dynamic> block(kSides, factor_->size());
  const Eigen::Index count = std::min<Eigen::Index>(kSides, rows.cols() - begin);
  block.setZero();
  for (std::size_t i = 0; i < free_.size(); ++i)
    block.col(factor_->place(static_cast<Eigen::Index>(i))).head(count) =
        rows.row(free_[i]).segment(begin, count).transpose().array();
  factor_->solve<kSides>(block);
  for (std::size_t i = 0; i < free_.size(); ++i)
    solution.row(free_[i]).segment(begin, count) =
        block.col(factor_->place(static_cast<Eigen::Index>(i))).head(count).transpose().matrix();
}

Substructure::Columns Substructure::inside(const Columns& rows) const {
  Columns solution = Columns::Zero(rows.rows(), rows.cols());
  for (Eigen::Index begin = 0; begin < rows.cols(); begin += kTogether)
    if (const Eigen::Index left = rows.cols() - begin; left == 1)
      solve_inside<1>(rows, begin, solution);
    else if (left <= 4)
      solve_inside<4>(rows, begin, solution);
    else
      solve_inside<kTogether>(rows, begin, solution);
  return solution;
}

Substructure::Columns Substructure::follow(const Columns& masters) const {
  const Columns moved = ties_ * masters;
  Columns motion = -inside(held_ * moved);
  for (std::size_t k = 0; k < tied_.size(); ++k)
    for (Eigen::Index component = 0; component < 2; ++component)
      motion.row(kFreedoms * tied_[k] + component) = moved.row(static_cast<Eigen::Index>(2 * k) + component);
  return motion;
}

Substructure::Columns Substructure::gather(const Columns& forces) const {
  Columns at_ties = -(held_.transpose() * inside(forces));
  for (std::size_t k = 0; k < tied_.size(); ++k)
    for (Eigen::Index component = 0; component < 2; ++component)
      at_ties.row(static_cast<Eigen::Index>(2 * k) + component) +=
          forces.row(kFreedoms * tied_[k] + component);
  return ties_.transpose() * at_ties;
}

// In blocks of columns, since T has as many as there are masters, and a row for each freedom.
Condensed Substructure::condense() const {
  const auto size = static_cast<Eigen::Index>(2 * masters_);
  Condensed condensed{Eigen::MatrixXd(size, size), Eigen::MatrixXd(size, size), gather(forces_)};
  constexpr Eigen::Index kBlock = 4 * kTogether;
  for (Eigen::Index begin = 0; begin < size; begin += kBlock) {
    const Eigen::Index count = std::min(kBlock, size - begin);
    Columns unit = Columns::Zero(size, count);
    for (Eigen::Index k = 0; k < count; ++k) unit(begin + k, k) = 1;
    const Columns motion = follow(unit);
    condensed.stiffness.middleCols(begin, count) = gather(stiffness_ * motion);
    condensed.mass.middleCols(begin, count) = gather(masses_.asDiagonal() * motion);
  }
  return condensed;
}

ParticlesMotion Substructure::recover(const MastersMotion& masters, double dt) const {
  const auto size = static_cast<Eigen::Index>(2 * masters_);
  Columns of_masters(size, 3);
  const std::span<const double> columns[] = {masters.displacements, masters.velocities_before,
                                             masters.velocities};
  for (Eigen::Index k = 0; k < 3; ++k)
    of_masters.col(k) = Eigen::Map<const Eigen::VectorXd>(columns[k].data(), size);
  Columns motion = follow(of_masters);
  const Columns acceleration = (motion.col(2) - motion.col(1)) / dt;
  const Eigen::VectorXd inertia = masses_.asDiagonal() * acceleration, lag = inside(inertia);
  motion.col(0) -= lag;
  const auto values = [&motion](Eigen::Index k) {
    return std::vector<double>(motion.col(k).begin(), motion.col(k).end());
  };
  return {values(0), values(1), values(2), 0.5 * inertia.dot(lag),
          0.5 * motion.col(2).dot(masses_.asDiagonal() * motion.col(2))};
}

}  // namespace adit::dem
