// A force given point by point over a change of length, such as that of a gasket: linear between the points,
// with the first and the last slope beyond them.
//
// What it stores is the integral of the force from the place without force that is nearest to opening 0 (from
// opening 0 where there is none), so that a gasket that is compressed when it is installed holds its energy
// from the beginning. The integral of a piecewise linear force is exact by trapezoids between its points, and
// so is the trapezoidal work of a step that stays on one slope.
#pragma once

#include <vector>

namespace adit::protocol {

class ForceCurve {
 public:
  // Two points or more, openings ascending; [m], [N], tension positive.
  ForceCurve(std::vector<double> opening, std::vector<double> force);

  double force(double opening) const;         // [N]
  double slope(double opening) const;         // of the force [N/m]
  double energy(double opening) const;        // [J]
  double steepest() const;                    // the largest |slope| [N/m]
  std::size_t segment(double opening) const;  // between two points that follow one another, from 0 on

 private:
  double slope_of(std::size_t segment) const;
  double integral(double opening) const;  // from the first point
  double without_force() const;           // the nearest to 0

  std::vector<double> opening_, force_;
  double datum_;  // integral at the place without force [J]
};

}  // namespace adit::protocol
