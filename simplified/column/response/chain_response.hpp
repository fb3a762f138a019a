// The response of the equivalent chain (chain.hpp) on rigid rock over time. It has the same interface as that
// of the oscillators (oscillator_response.hpp) and gives the same results.
#pragma once

#include <Eigen/Core>
#include <span>

#include "simplified/column/response/chain.hpp"
#include "simplified/column/response/recursion.hpp"

namespace adit::simplified::column {

// M v'' + C v' + K v = -M 1 a(t), solved exactly for an acceleration that varies linearly between its samples
// (exponential of the system's matrix, recursion.hpp). The chain is at rest at t = 0, with a = 0; a step
// advances it by dt [s].
class ChainResponse {
 public:
  ChainResponse(const Chain& chain, double dt);
  // `base_acceleration` is that at the end of the step [m/s^2].
  void step(double base_acceleration);

  // Motion relative to the base, at the depth of the shapes (shapes_at) [m], [m/s].
  double displacement(std::span<const double> shapes) const;
  double velocity(std::span<const double> shapes) const;
  // Absolute acceleration [m/s^2].
  double acceleration(std::span<const double> shapes) const;
  // Force per area on the deposit: that of spring 0, of the dashpots, and of the rigid mass [Pa].
  double base_force() const;

 private:
  Eigen::VectorXd internal_force() const;  // K v + C v' [Pa]

  Chain chain_;
  Recursion recursion_;
  Eigen::VectorXd state_, next_;  // v, then v'
  double base_acceleration_ = 0;
};

}  // namespace adit::simplified::column
