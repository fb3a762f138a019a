// The response of the oscillators of a modal column (modal_column.hpp) on rigid rock over time.
#pragma once

#include <span>
#include <vector>

#include "simplified/column/modes/modal_column.hpp"

namespace adit::simplified::column::test {

// The oscillators q'' + 2 xi omega q' + omega^2 q = -a(t) are solved exactly for an acceleration a that
// varies linearly between its samples (Nigam and Jennings 1969): there is no error of period or damping at
// any time step. They are at rest at t = 0, with a = 0; a step advances them by dt [s].
class OscillatorResponse {
 public:
  OscillatorResponse(const ModalColumn& column, double dt);
  // `base_acceleration` is that at the end of the step [m/s^2].
  void step(double base_acceleration);

  // Motion relative to the base, at the depth of the shapes (shapes_at) [m], [m/s].
  double displacement(std::span<const double> shapes) const;
  double velocity(std::span<const double> shapes) const;
  // Absolute acceleration [m/s^2].
  double acceleration(std::span<const double> shapes) const;
  // Force per area on the deposit [Pa].
  double base_force() const;

 private:
  struct Coefficients {  // q, q' at the end of a step from q, q', a at its start and a at its end
    std::vector<double> qq, qv, vq, vv, q_start, q_end, v_start, v_end;
  };
  Coefficients coefficients_;
  std::vector<double> frequency_, damping_, mass_, displacement_, velocity_;
  double rigid_mass_, base_acceleration_ = 0;
};

}  // namespace adit::simplified::column::test
