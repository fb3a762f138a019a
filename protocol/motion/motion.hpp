// Ground motions: acceleration at equal time steps, linear between two values, zero before the first value.
// Times count from the first value, and a motion of n values lasts (n - 1) dt.
//
// Every function of this folder throws protocol::UserError with an empty path if its input cannot be used;
// the caller, who knows the scene, adds the field (errors_at.hpp).
#pragma once

#include <string_view>
#include <vector>

namespace adit::motion {

struct Motion {
  double dt = 0;                     // [s]
  std::vector<double> acceleration;  // [m/s^2]

  double duration() const;  // [s]
};

// Refuses a motion whose step is not positive, that has no values, or whose values are not all finite. Every
// function on motions calls this first.
void check(const Motion& motion);

// Refuses a motion that ends before `duration` [s]; the message calls it `name`.
void require_duration(const Motion& motion, double duration, std::string_view name);

// Refuses a value that is not finite and above zero: "the <what> is -1; give a value above 0".
void require_positive(double value, std::string_view what);

// Velocity [m/s] and displacement [m] at the times of the motion, both zero at time 0. They are the exact
// integrals of the straight lines between the values:
//   v' = v + dt (a + a') / 2,   u' = u + dt v + dt^2 (2 a + a') / 6.
struct Course {
  std::vector<double> velocity;
  std::vector<double> displacement;
};
Course integrate(const Motion& motion);

}  // namespace adit::motion
