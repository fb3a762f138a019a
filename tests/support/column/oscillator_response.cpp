#include "tests/support/column/oscillator_response.hpp"

#include "tests/support/column/recursion.hpp"

namespace adit::simplified::column::test {

OscillatorResponse::OscillatorResponse(const ModalColumn& column, double dt)
    : displacement_(column.modes.size()), velocity_(column.modes.size()), rigid_mass_(column.rigid_mass) {
  for (const Mode& mode : column.modes) {
    const double omega = mode.frequency;
    Eigen::Matrix2d A;
    A << 0, 1, -omega * omega, -2 * mode.damping * omega;
    const Recursion r = piecewise_linear(A, Eigen::Vector2d(0, -1), dt);
    Coefficients& c = coefficients_;
    c.qq.push_back(r.transition(0, 0)), c.qv.push_back(r.transition(0, 1));
    c.vq.push_back(r.transition(1, 0)), c.vv.push_back(r.transition(1, 1));
    c.q_start.push_back(r.from_start[0]), c.q_end.push_back(r.from_end[0]);
    c.v_start.push_back(r.from_start[1]), c.v_end.push_back(r.from_end[1]);
    frequency_.push_back(omega), damping_.push_back(mode.damping), mass_.push_back(mode.effective_mass);
  }
}

void OscillatorResponse::step(double base_acceleration) {
  const Coefficients& c = coefficients_;
  for (std::size_t n = 0; n < displacement_.size(); ++n) {
    const double q = displacement_[n], v = velocity_[n];
    displacement_[n] =
        c.qq[n] * q + c.qv[n] * v + c.q_start[n] * base_acceleration_ + c.q_end[n] * base_acceleration;
    velocity_[n] =
        c.vq[n] * q + c.vv[n] * v + c.v_start[n] * base_acceleration_ + c.v_end[n] * base_acceleration;
  }
  base_acceleration_ = base_acceleration;
}

double OscillatorResponse::displacement(std::span<const double> shapes) const {
  double sum = 0;
  for (std::size_t n = 0; n < displacement_.size(); ++n) sum += shapes[n] * displacement_[n];
  return sum;
}

double OscillatorResponse::velocity(std::span<const double> shapes) const {
  double sum = 0;
  for (std::size_t n = 0; n < velocity_.size(); ++n) sum += shapes[n] * velocity_[n];
  return sum;
}

// The absolute acceleration a + sum psi_n q_n'', where q_n'' + a = -(omega^2 q + 2 xi omega q').
double OscillatorResponse::acceleration(std::span<const double> shapes) const {
  double sum = base_acceleration_;
  for (std::size_t n = 0; n < displacement_.size(); ++n)
    sum -= shapes[n] * (frequency_[n] * (frequency_[n] * displacement_[n] + 2 * damping_[n] * velocity_[n]) +
                        base_acceleration_);
  return sum;
}

double OscillatorResponse::base_force() const {
  double sum = rigid_mass_ * base_acceleration_;
  for (std::size_t n = 0; n < displacement_.size(); ++n)
    sum -= mass_[n] * frequency_[n] * (frequency_[n] * displacement_[n] + 2 * damping_[n] * velocity_[n]);
  return sum;
}

}  // namespace adit::simplified::column::test
