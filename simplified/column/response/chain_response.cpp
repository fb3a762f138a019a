#include "simplified/column/response/chain_response.hpp"

namespace adit::simplified::column {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// The system in the state (v, v'): (v, v')' = [[0, 1], [-M^-1 K, -M^-1 C]] (v, v') - (0, 1) a.
Recursion recursion_of(const Chain& chain, double dt) {
  const Index n = chain.masses.size();
  const auto inverse_masses = chain.masses.cwiseInverse();
  MatrixXd A = MatrixXd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n).setIdentity();
  A.bottomLeftCorner(n, n) = -(inverse_masses.asDiagonal() * chain.stiffness);
  A.bottomRightCorner(n, n) = -(inverse_masses.asDiagonal() * chain.dashpots);
  VectorXd b(2 * n);
  b << VectorXd::Zero(n), VectorXd::Constant(n, -1);
  return piecewise_linear(A, b, dt);
}

double along(const Chain& chain, std::span<const double> shapes, const VectorXd& masses) {
  return VectorXd::Map(shapes.data(), static_cast<Index>(shapes.size())).dot(chain.oscillators * masses);
}

}  // namespace

ChainResponse::ChainResponse(const Chain& chain, double dt)
    : chain_(chain),
      recursion_(recursion_of(chain, dt)),
      state_(VectorXd::Zero(2 * chain.masses.size())),
      next_(state_) {}

void ChainResponse::step(double base_acceleration) {
  next_.noalias() = recursion_.transition * state_;
  next_ += recursion_.from_start * base_acceleration_ + recursion_.from_end * base_acceleration;
  state_.swap(next_);
  base_acceleration_ = base_acceleration;
}

double ChainResponse::displacement(std::span<const double> shapes) const {
  return along(chain_, shapes, state_.head(chain_.masses.size()));
}

double ChainResponse::velocity(std::span<const double> shapes) const {
  return along(chain_, shapes, state_.tail(chain_.masses.size()));
}

VectorXd ChainResponse::internal_force() const {
  const Index n = chain_.masses.size();
  return chain_.stiffness * state_.head(n) + chain_.dashpots * state_.tail(n);
}

double ChainResponse::acceleration(std::span<const double> shapes) const {
  // Nothing but springs and dashpots acts on a mass, so they give its absolute acceleration without
  // differences in time.
  const VectorXd absolute = -internal_force().cwiseQuotient(chain_.masses);
  const VectorXd relative = absolute.array() - base_acceleration_;
  return base_acceleration_ + along(chain_, shapes, relative);
}

double ChainResponse::base_force() const {
  // The force at the base moves all masses: m a of the rigid mass, and for each of the others minus its
  // internal force. Forces between masses cancel in the sum.
  return chain_.rigid_mass * base_acceleration_ - internal_force().sum();
}

}  // namespace adit::simplified::column
