// Values known at places along the tunnel, anywhere between them.
#pragma once

#include <cstddef>
#include <vector>

namespace adit::simplified {

// The natural cubic spline through the places. A tunnel that follows the ground has the ground's curvature,
// so that must not sit at the places alone: the spline's is continuous, and of a wave of q [rad/m] at places
// h apart it errs by (q h)^2/12 at most, the displacement by 5/384 (q h)^4 (Hall and Meyer 1976).
class AlongChainage {
 public:
  // `places` ascend, two or more; beyond them the values of the first and the last go on.
  AlongChainage(const std::vector<double>& places, const std::vector<double>& chainages);

  // to[i]: at chainage i, from one value a place.
  void interpolate(const double* values, double* to);

 private:
  // a v_k + b v_k+1 + c v''_k + d v''_k+1 between the places k and k + 1.
  struct Point {
    std::size_t before;
    double a, b, c, d;
  };
  void find_curvatures(const double* values);

  std::vector<double> gaps_;    // between the places [m]
  std::vector<double> pivots_;  // inverse, of the equations for the curvatures
  std::vector<double> curvatures_;
  std::vector<Point> points_;
};

}  // namespace adit::simplified
