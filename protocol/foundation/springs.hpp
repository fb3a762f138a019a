// Springs and dashpots between points of a model and ground that moves by itself, in one direction.
//
// Per area, with the elongation e = u_g - u and h the hardening:
//   F = h k e + s + c (v_g - v),   s follows (1 - h) k de and stays within +-(1 - h) f_slip.
// e and s are those of step n, found from the velocities of n - 1/2. The dashpot takes the mean of the
// point's velocities of n - 1/2 and n + 1/2, so that it does not shorten the time step
// (fdm_server/solver/dashpots.hpp):
//   c (v_g - v) = c (v_g - v(n-1/2) - kick/2 W f) / (1 + c kick/2 W),   f all other forces, W the inverse
//   mass.
// What ties a point of an interface to another model is not among the forces that are known. Dashpots take
// the velocity of n - 1/2 alone there, which has been corrected:
//   c (v_g - v(n-1/2)) / (1 + c kick/2 W).
// Springs therefore pull before what needs their force, dashpots after all else. Where others' dashpots act
// on the same point, each one sees the drag of those before it: together they brake as the product of their
// factors 1 / (1 + c kick/2 W), which is stable for any of them.
// The springs do: they add at most k / rho to the omega^2 of a zone or particle of density rho.
//
// Energies by the trapezoid that the scheme keeps: the ground does dt v_g (F(n) + F(n+1))/2, the points get
// dt v (F(n) + F(n+1))/2, the springs store h k e^2/2 + s^2 / 2 (1-h) k, and slip and dashpots take the rest.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "protocol/foundation/ground_course.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::foundation {

struct SpringLaw {
  double stiffness, dashpot;      // per area [N/m^3], [N s/m^3]
  double slip_stress, hardening;  // [N/m^2], in [0, 1)
};

struct HeldPoint {
  std::uint32_t point;
  double area;  // weighted [m^2]
  double x;     // at which the ground's motion is taken [m]
};

// One component of the points' motion; the forces are added to.
struct PointMotion {
  const double *velocity, *inverse_mass;
  double* force;
};

class Springs {
 public:
  Springs(Direction direction, const SpringLaw& law, std::shared_ptr<const GroundCourse> ground,
          const std::vector<HeldPoint>& points);

  // Takes the springs of the chosen points out, before the first step.
  Springs take(const std::vector<bool>& chosen);
  void mark(std::vector<bool>& points) const;
  // The motion of these points is that of another model, too.
  void tie(std::span<const std::uint32_t> points);
  bool empty() const { return points_.empty(); }
  Direction direction() const { return direction_; }
  bool holds(std::uint32_t begin, std::uint32_t end) const;  // a point of begin ... end - 1

  // Adds the springs' forces of step n to those of the points.
  void pull(const protocol::Step& step, const PointMotion& motion);
  // Then the dashpots' to those of the points, which hold all others.
  void brake(const protocol::Step& step, const PointMotion& motion);

  double stored() const;                             // [J]
  double work() const { return work_; }              // of the ground since the start [J]
  double dissipated() const { return dissipated_; }  // likewise
  void start_over() { work_ = dissipated_ = 0; }
  void exchange(state::Archive& archive) {
    archive.members("foundation_points", std::span(points_), &Point::elongation, &Point::slider,
                    &Point::force);
    archive("foundation_work", work_);
    archive("foundation_dissipated", dissipated_);
  }

 private:
  struct Point {
    std::uint32_t point;
    double area;
    Bracket place;
    bool tied = false;
    double elongation = 0, slider = 0, force = 0;  // [m], [N/m^2], [N]
    double stored_before = 0;                      // this step [J]
  };
  double stored(const Point& point) const;
  double spring(const Point& point) const;  // its force [N]
  void stretch(Point& point, double by) const;

  Direction direction_;
  SpringLaw law_;
  std::shared_ptr<const GroundCourse> ground_;
  std::vector<Point> points_;
  std::vector<double> before_, now_;  // the ground's velocity at its places at n - 1/2 and n
  double work_ = 0, dissipated_ = 0;
};

}  // namespace adit::foundation
