// Ground motions: acceleration at equal steps of time, a straight line between two values, zero before the
// first. Times count from the first value. A motion of n values lasts (n - 1) dt.
//
// Every function of this folder throws protocol::UserError, with an empty path, where its input cannot be
// used; the caller who knows the scene adds the field.
#pragma once

#include <string_view>
#include <vector>

namespace adit::motion {

struct Motion {
  double dt = 0;                     // [s]
  std::vector<double> acceleration;  // [m/s^2]

  double duration() const;  // [s]
};

// Refuses a step that is not positive, no values, and values that are not finite. Every function below and
// in the other headers asks for this first.
void check(const Motion& motion);

// Refuses a motion that ends before `duration` [s]; `name` is what the message calls it.
void require_duration(const Motion& motion, double duration, std::string_view name);

// Refuses a value that is not finite and above zero: "the <what> is -1; give a value above 0".
void require_positive(double value, std::string_view what);

// Velocity [m/s] and displacement [m] at the times of the motion, both zero at time 0. The integrals of the
// straight lines are taken exactly:
//   v' = v + dt (a + a') / 2,   u' = u + dt v + dt^2 (2 a + a') / 6.
struct Course {
  std::vector<double> velocity;
  std::vector<double> displacement;
};
Course integrate(const Motion& motion);

}  // namespace adit::motion
