// The chain as the kernels read it: a structure of arrays, with an abutment as a further body before the
// first and after the last one.
//
// Places 1 … n are the bodies; 0 and n + 1 are the abutments, which have no length and a prescribed motion.
// Hinge j lies between the places j and j + 1; a free end is a hinge without stiffness.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "simplified/chain/model/chain.hpp"

namespace adit::simplified::chain {

using Matrix3 = Eigen::Matrix3d;
using Vector3 = Eigen::Vector3d;

// Three components of everything: x, y, rotation in the plane, or axial, shear, rotation in a hinge's axes.
using Components = std::array<std::vector<double>, 3>;

// Symmetric 3x3 matrices without coupling of rotation and translation, in the axes of the plane.
struct PlaneSprings {
  std::vector<double> xx, xy, yy, rr;
  Matrix3 at(std::size_t i) const;
};

struct Model {
  explicit Model(const Chain& chain);
  std::size_t bodies;  // n

  std::vector<double> mass, inertia;  // n + 2 values here and below
  std::vector<double> half_x,
      half_y;  // from the centre to the outgoing port [m]; the ingoing one is opposite
  PlaneSprings ground_stiffness, ground_dashpot;

  std::vector<double> cos, sin;   // direction of the hinges' axes; n + 1 values here and below
  Components stiffness, dashpot;  // properties of the hinges; the tangent stiffness if there is a curve
  Components offset;              // force of the tangent at zero deformation, without the force at rest
  Components at_rest;             // force at rest, which outer forces balance

  // A diag(m, m, J) + K + C C_g of body i.
  Matrix3 dynamic_stiffness(std::size_t i, double A, double C) const;
  // K + C C_h of hinge j, in the axes of the plane.
  Matrix3 hinge_stiffness(std::size_t j, double C) const;
  // The matrix G that maps the motion of the centre of i to that of a port; its transpose maps a force at the
  // port to one at the centre.
  Matrix3 outgoing_port(std::size_t i) const;
  Matrix3 ingoing_port(std::size_t i) const;
};

Components components(std::size_t size);

}  // namespace adit::simplified::chain
