// Implicit time integration, one degree of freedom at a time.
//
// Every method writes the acceleration and velocity at the end of the step (at theta steps, for Wilson) as
//   a = A x + B,  v = C x + D,
// with A and C constants of the method and B, D from the steps before (discrete-time transfer matrices, the
// paper's section 3.1). To avoid differences of large numbers, a displacement p is predicted and the unknown
// is the correction y = x - p, so that
//   a = A y,  v = C y + q        that is, B = -A p and D = q - C p.
//   Newmark   p = x + dt v + (1/2 - beta) dt^2 a,  q = v + (1 - gamma) dt a,  A = 1/(beta dt^2), C = gamma dt
//   A Wilson    Newmark's linear acceleration (beta 1/6, gamma 1/2) over theta dt; then the acceleration is
//             interpolated back to dt
//   Houbolt   p = (5 x - 4 x' + x'') / 2,  q = (11 p - 18 x + 9 x' - 2 x'') / (6 dt), with the
//             displacements one (x') and two (x'') steps earlier;  A = 2/dt^2, C = 11/(6 dt)
// All are of second order, Newmark if gamma = 1/2. The first two steps of Houbolt's method are made with
// Newmark's average acceleration.
#pragma once

#include <cstddef>
#include <span>
#include <variant>
#include <vector>

namespace adit::simplified::chain {

struct Newmark {
  double beta = 0.25, gamma = 0.5;
};
struct WilsonTheta {
  double theta = 1.4;
};
struct Houbolt {};
using Method = std::variant<Newmark, WilsonTheta, Houbolt>;

// Throws protocol::UserError at `integrator.…` or `dt`.
void check(const Method& method, double dt);

// The motion of many degrees of freedom of one kind.
struct Track {
  Track(std::size_t size, const Method& method);
  std::vector<double> x, v, a;  // present motion [m, m/s, m/s^2] or [rad, …]
  std::vector<double> p, q;     // predicted displacement and velocity
  std::vector<double> x1, x2;  // displacement one and two steps earlier; empty unless the method is Houbolt's
};

class Integrator {
 public:
  // The method as it is used from step `step` on; the first step is 0.
  Integrator(const Method& method, double dt, long step);

  double A() const { return A_; }
  double C() const { return C_; }
  double theta() const {
    return theta_;
  }  // the equations hold this many steps ahead; 1 except for Wilson's method

  // p and q of the degrees of freedom begin … end - 1.
  void predict(Track& track, std::size_t begin, std::size_t end) const;
  // x, v and a at the end of the step, from the corrections y.
  void correct(Track& track, std::span<const double> y, std::size_t begin, std::size_t end) const;

 private:
  enum class Kind { kNewmark, kWilson, kHoubolt } kind_;
  double dt_, beta_ = 0, gamma_ = 0, theta_ = 1, A_, C_;
};

inline constexpr long kHouboltStart = 2;  // number of first steps that are made with Newmark's method

}  // namespace adit::simplified::chain
