// The least that forces of links lack for balance: a linear static solution on springs of reference.
//
// Where the forces of the links and what acts from outside leave the resultant R(i) on the free motions i,
// the links add K u = R, K being their stiffness: forces that balance exactly, and of all that do those
// nearest to the given ones in the energy of the reference springs. A motion that no link resists gets a
// millionth of a thousandth of a spring, whose force the next pass takes away. Forces that balance already,
// as those of a lattice under a stress that does, need no solution.
#pragma once

#include <Eigen/SparseCholesky>
#include <span>
#include <vector>

#include "dem_server/model/initial_state/network.hpp"

namespace adit::dem {

// Whether the forces of the links balance `external` on all motions that are not held, but for rounding.
// `external`: force x, force y [N] and moment [N m] on each disc; `held`: x, y and rotation of each.
bool in_balance(std::span<const Link> links, std::span<const double> external, const std::vector<bool>& held,
                const std::vector<PairForces>& forces);

class Equilibrium {
 public:
  Equilibrium(std::span<const Link> links, const Discs& discs, const std::vector<bool>& held);

  // Makes the forces of the links, in their order, balance `external`.
  void balance(std::span<const Link> links, std::span<const double> external,
               std::vector<PairForces>& forces) const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;

  Eigen::VectorXd of_free(const Eigen::VectorXd& resultants) const;

  std::vector<int> place_;  // of each motion among the free ones; -1: held
  int free_ = 0;
  Eigen::SimplicialLDLT<Matrix> factor_;
};

}  // namespace adit::dem
