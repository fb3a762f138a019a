#include "dem_server/model/initial_state/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace adit::dem {
namespace {

constexpr double kSofter = 1e-9;    // of a spring
constexpr double kRounding = 1e-9;  // of the largest force
constexpr int kPasses = 3;          // each makes what is left out of balance smaller by many digits

std::array<std::size_t, 6> motions_of(const Link& link) {
  const std::size_t i = 3 * std::size_t{link.first}, j = 3 * std::size_t{link.second};
  return {i, i + 1, i + 2, j, j + 1, j + 2};
}

// What the forces of the links leave of `external`.
Eigen::VectorXd resultants(std::span<const Link> links, std::span<const double> external,
                           const std::vector<PairForces>& forces) {
  Eigen::VectorXd sum =
      Eigen::Map<const Eigen::VectorXd>(external.data(), static_cast<Eigen::Index>(external.size()));
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto motions = motions_of(links[k]);
    const Stretching rows = stretching(links[k]);
    for (std::size_t a = 0; a < 6; ++a)
      sum[static_cast<Eigen::Index>(motions[a])] -=
          rows[0][a] * forces[k].normal + rows[1][a] * forces[k].shear + rows[2][a] * forces[k].moment;
  }
  return sum;
}

}  // namespace

bool in_balance(std::span<const Link> links, std::span<const double> external, const std::vector<bool>& held,
                const std::vector<PairForces>& forces) {
  double force = 0, arm = 0;
  for (std::size_t k = 0; k < links.size(); ++k) {
    force = std::max({force, std::abs(forces[k].normal), std::abs(forces[k].shear)});
    arm = std::max({arm, links[k].arm_1, links[k].arm_2});
  }
  const Eigen::VectorXd left = resultants(links, external, forces);
  for (std::size_t m = 0; m < held.size(); ++m) {
    const double rounding = kRounding * force * (m % 3 == 2 ? arm : 1);
    if (!held[m] && !(std::abs(left[static_cast<Eigen::Index>(m)]) <= rounding)) return false;
  }
  return true;
}

Equilibrium::Equilibrium(std::span<const Link> links, const Discs& discs, const std::vector<bool>& held)
    : place_(held.size(), -1) {
  for (std::size_t m = 0; m < held.size(); ++m)
    if (!held[m]) place_[m] = free_++;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(36 * links.size() + held.size());
  for (std::size_t m = 0; m < held.size(); ++m) {
    const double lever = m % 3 == 2 ? discs.radius[m / 3] : 1;
    if (!held[m]) entries.emplace_back(place_[m], place_[m], kSofter * lever * lever);
  }
  for (const Link& link : links) {
    const auto motions = motions_of(link);
    const Stretching rows = stretching(link);
    for (std::size_t a = 0; a < 6; ++a)
      for (std::size_t b = 0; b < 6; ++b) {
        const int row = place_[motions[a]], column = place_[motions[b]];
        if (row < 0 || column < 0 || row < column) continue;
        entries.emplace_back(row, column,
                             link.kn * rows[0][a] * rows[0][b] + link.ks * rows[1][a] * rows[1][b] +
                                 link.km * rows[2][a] * rows[2][b]);
      }
  }
  Matrix stiffness(free_, free_);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  factor_.compute(stiffness);
  if (factor_.info() != Eigen::Success)
    throw std::logic_error("the stiffness of the links that balance the initial state is singular");
}

Eigen::VectorXd Equilibrium::of_free(const Eigen::VectorXd& resultants) const {
  Eigen::VectorXd free(free_);
  for (std::size_t m = 0; m < place_.size(); ++m)
    if (place_[m] >= 0) free[place_[m]] = resultants[static_cast<Eigen::Index>(m)];
  return free;
}

void Equilibrium::balance(std::span<const Link> links, std::span<const double> external,
                          std::vector<PairForces>& forces) const {
  if (free_ == 0) return;
  for (int pass = 0; pass < kPasses; ++pass) {
    const Eigen::VectorXd u = factor_.solve(of_free(resultants(links, external, forces)));
    for (std::size_t k = 0; k < links.size(); ++k) {
      const auto motions = motions_of(links[k]);
      const Stretching rows = stretching(links[k]);
      std::array<double, 3> stretch{};
      for (std::size_t a = 0; a < 6; ++a)
        if (place_[motions[a]] >= 0)
          for (std::size_t row = 0; row < 3; ++row) stretch[row] += rows[row][a] * u[place_[motions[a]]];
      forces[k].normal += links[k].kn * stretch[0];
      forces[k].shear += links[k].ks * stretch[1];
      forces[k].moment += links[k].km * stretch[2];
    }
  }
}

}  // namespace adit::dem
