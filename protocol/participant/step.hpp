// A step as the kernels see it: when it is, and whether it starts from rest.
#pragma once

#include <cstdint>

namespace adit::protocol {

struct Step {
  std::uint64_t number;
  double dt;                 // [s]
  bool relax = false;        // statics: time stands still at 0, prescribed velocities are 0
  bool stop = false;         // all velocities were set to 0 before this step
  double local_damping = 0;  // statics: share of the unbalanced force that acts against the velocity

  // It does not move, and predicts by half a kick, as if v(-1/2) = -v(1/2).
  bool from_rest() const { return number == 0 || stop; }
  double kick() const { return from_rest() ? dt / 2 : dt; }
  double time() const { return relax ? 0 : static_cast<double>(number) * dt; }
  double half_time() const { return (static_cast<double>(number) + 0.5) * dt; }
};

// A velocity of a whole model [m/s].
struct Drift {
  double x = 0, y = 0;
};

}  // namespace adit::protocol
