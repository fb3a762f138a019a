// The equivalent chain (chain.hpp) on rigid rock over time: the same interface as the oscillators'
// (oscillator_response.hpp), the same answer.
#pragma once

#include <Eigen/Core>
#include <span>

#include "simplified/column/response/chain.hpp"
#include "simplified/column/response/recursion.hpp"

namespace adit::simplified::column {

// M v'' + C v' + K v = -M 1 a(t), exact for an acceleration that varies linearly between its samples
// (exponential of the system's matrix, recursion.hpp). At rest at t = 0, with a = 0; each step goes on by dt
// [s].
class ChainResponse {
 public:
  ChainResponse(const Chain& chain, double dt);
  // base_acceleration: at the end of the step [m/s^2].
  void step(double base_acceleration);

  // Relative to the base, at the depth of the shapes (shapes_at) [m], [m/s].
  double displacement(std::span<const double> shapes) const;
  double velocity(std::span<const double> shapes) const;
  // Absolute [m/s^2].
  double acceleration(std::span<const double> shapes) const;
  // Per area, on the deposit: what spring 0 and the dashpots pass, and the rigid mass [Pa].
  double base_force() const;

 private:
  Eigen::VectorXd internal_force() const;  // K v + C v' [Pa]

  Chain chain_;
  Recursion recursion_;
  Eigen::VectorXd state_, next_;  // v, then v'
  double base_acceleration_ = 0;
};

}  // namespace adit::simplified::column
