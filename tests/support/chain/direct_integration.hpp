// The same equations by general means: global sparse matrices and Eigen's LDL^T. What the Riccati sweep is
// measured against. Linear hinges only.
#pragma once

#include <Eigen/Sparse>

#include "simplified/chain/joints/integrator.hpp"
#include "simplified/chain/simulation.hpp"

namespace adit::simplified::chain::test {

class DirectIntegration {
 public:
  // At rest. `tolerance` and `max_iterations` of the settings have no meaning here. Throws
  // std::invalid_argument where a hinge has a curve.
  DirectIntegration(const Chain& chain, const Settings& settings);

  void step(const Excitation& at_end);

  // x, y, rotation of body 0, of body 1, …
  const std::vector<double>& displacement() const { return motion_.x; }

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;
  void factor();
  Vector load(const Excitation& excitation) const;

  Integrator integrator_;
  std::size_t bodies_;
  Sparse mass_, stiffness_, dashpot_;
  // Forces from the motions of the ground: x, y under body 0, under body 1, …; abutments move with the end
  // bodies'.
  Sparse ground_stiffness_, ground_dashpot_;
  Eigen::SimplicialLDLT<Sparse> solver_;
  Track motion_;
  Vector load_;
};

}  // namespace adit::simplified::chain::test
