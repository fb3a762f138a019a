// The velocity constraint over all coupling points of a model: one system, whatever sides and interfaces it
// joins, so that interfaces may share grid points.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coupler/bridging/multipliers.hpp"
#include "coupler/interface.hpp"
#include "coupler/side.hpp"

namespace adit::coupler {

class Constraint {
 public:
  // `points`: the coupling points of all interfaces in turn, x0 y0 x1 y1 …; dt: time between two corrections
  // [s]. Every side has its operator. Throws protocol::UserError where a point is tied twice, where the
  // interfaces name different solves, and for what the solve itself refuses.
  Constraint(const std::vector<Side>& sides, const std::vector<Interface>& interfaces,
             std::span<const double> points, double dt);

  // From the predicted velocities of all sides to the impulses on them.
  void solve(std::vector<Side>& sides);

  const MultiplierSolve& multipliers() const { return *solve_; }

 private:
  std::unique_ptr<MultiplierSolve> solve_;
  std::vector<double> coarse_, fine_, multipliers_;  // one pair for each coupling point
};

}  // namespace adit::coupler
