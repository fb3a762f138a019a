// Newmark's implicit integration in time, one degree of freedom at a time (Newmark 1959, J. Eng. Mech. Div.
// 85).
//
// The acceleration and velocity at the end of the step are
//   a = A x + B,  v = C x + D,
// with constants A and C, and B, D from the step before (discrete-time transfer matrices, the paper's section
// 3.1). To avoid differences of large numbers, a displacement p is predicted and the unknown is the
// correction y = x - p, so that
//   a = A y,  v = C y + q        that is, B = -A p and D = q - C p,
//   p = x + dt v + (1/2 - beta) dt^2 a,  q = v + (1 - gamma) dt a,  A = 1/(beta dt^2), C = gamma dt A.
// The method is of second order if gamma = 1/2.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace adit::simplified::chain {

struct Newmark {
  double beta = 0.25, gamma = 0.5;
};

// Throws protocol::UserError at `integrator.…` or `dt`.
void check(const Newmark& newmark, double dt);

// The motion of many degrees of freedom of one kind.
struct Track {
  explicit Track(std::size_t size) : x(size), v(size), a(size), p(size), q(size) {}
  std::vector<double> x, v, a;  // present motion [m, m/s, m/s^2] or [rad, …]
  std::vector<double> p, q;     // predicted displacement and velocity
};

class Integrator {
 public:
  Integrator(const Newmark& newmark, double dt);

  double A() const { return A_; }
  double C() const { return C_; }

  // p and q of the degrees of freedom begin … end - 1.
  void predict(Track& track, std::size_t begin, std::size_t end) const;
  // x, v and a at the end of the step, from the corrections y.
  void correct(Track& track, std::span<const double> y, std::size_t begin, std::size_t end) const;

 private:
  double dt_, beta_, gamma_, A_, C_;
};

}  // namespace adit::simplified::chain
