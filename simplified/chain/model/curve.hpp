// A joint's force over its deformation: gaskets that only press and harden, shear keys with clearance, stops.
//
// Straight lines between the points, the first and last line continued for ever. With the joint's opening
// positive, a gasket that is pressed by 171 MN at rest and parts after 30 mm of opening is
//   deformation -0.05 0 0.03 0.04, force -600e6 -171e6 0 0.
// What the curve says at zero deformation is the force at rest; constant outer forces (the water) balance it,
// so the chain stays at rest with it. Results report the whole force.
#pragma once

#include <string>
#include <vector>

namespace adit::simplified::chain {

struct Curve {
  std::vector<double> deformation;  // strictly increasing [m] or [rad]
  std::vector<double> force;        // not decreasing, one for each deformation [N] or [N m]
  bool empty() const { return deformation.empty() && force.empty(); }
};

// Throws protocol::UserError at `path`.deformation or `path`.force where the points make no curve.
void check(const Curve& curve, const std::string& path);

// The straight line of the curve at one deformation: force = offset + slope * deformation.
struct Line {
  double slope, offset;
  double at(double deformation) const { return offset + slope * deformation; }
};

// The curve is checked and not empty.
Line line_at(const Curve& curve, double deformation);

}  // namespace adit::simplified::chain
