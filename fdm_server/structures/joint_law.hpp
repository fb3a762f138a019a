// The joint of two segments of a lining: faces that press on one another, bolts in tension, a gasket. Per
// metre of thickness of the plane.
//
// Opening: at z to the right of the axis the faces part by x(z) = delta + phi z. N and M, about the axis, are
// positive as in beam.hpp.
//
// Faces (Janssen, P.: Tragverhalten von Tunnelausbauten mit Gelenktuebbings, Braunschweig 1983; Blom, C.B.M.:
// Design philosophy of concrete linings for tunnels in soft soils, Delft 2002): between them lies a block of
// the contact's height h and of the same length. Its strain x/h is linear over the height and has no tension:
//   N = E/h int x dz,   M = E/h int x z dz,   over |z| <= h/2 with x < 0.
// Both derive from the energy E/2h int x^2 dz. Of the closed joint N = E delta, M = E h^2/12 phi, up to
// |M| = |N| h/6; beyond it
//   |phi| = 8 |N| / (9 h E (2 |M|/(N h) - 1)^2),   |M| < |N| h/2,
// and the axis lengthens as the joint opens. The matrix of second derivatives is exact, as the pressure
// vanishes at the end of the contact.
//
// Bolts: T = k (x - p), between 0 and the yield force; p is where they become slack. It grows when they
// yield. Gasket: a force by opening that never falls (springs/force_curve.hpp).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "protocol/springs/force_curve.hpp"

namespace adit::fdm {

using JointOpening = Eigen::Vector2d;  // delta [m], phi [rad]
using JointForces = Eigen::Vector2d;   // N [N], M [N m]

struct JointFaces {
  double height;  // h [m]
  double young;   // E [Pa]

  JointForces forces(const JointOpening& opening) const { return stiffness(opening) * opening; }
  Eigen::Matrix2d stiffness(const JointOpening& opening) const;
  Eigen::Matrix2d closed() const;  // the largest stiffness
};

struct JointBolts {
  double stiffness, pretension, yield;  // k [N/m], force when installed and largest one [N]
  double position;                      // z [m]
  double spacing;                       // a force times this is that of one bolt [m]

  double force(double opening, double slack) const;
  double stiffness_at(double opening, double slack) const;
};

struct JointGasket {
  protocol::ForceCurve force;
  double position;     // z [m]
  double water_force;  // pressure of the water times the width of the gasket [N]; 0: not known
};

struct JointLaw {
  JointFaces faces;
  std::vector<JointBolts> bolts{};
  std::optional<JointGasket> gasket{};
  double edge = 0;  // half the lining's thickness [m]

  // `slack`: p of each row of bolts [m].
  JointForces forces(const JointOpening& opening, std::span<const double> slack) const;
  Eigen::Matrix2d stiffness(const JointOpening& opening, std::span<const double> slack) const;
  double stored(const JointOpening& opening, std::span<const double> slack) const;  // [J]

  // The opening d beyond `opening` at which forces + k d are `load`; k is symmetric and positive definite.
  // Unique, since the energy is convex.
  JointOpening solve(const JointOpening& opening, std::span<const double> slack, const Eigen::Matrix2d& k,
                     const JointForces& load) const;

  // Where faces and gasket balance the pretension, so that the joint is free of thrust and moment. None where
  // they cannot: the pretension acts beside the faces.
  std::optional<JointOpening> installed() const;
};

inline double opening_at(const JointOpening& opening, double position) {
  return opening[0] + opening[1] * position;
}

}  // namespace adit::fdm
