// A straight beam element between two nodes: linear along the axis, bending in two planes with or without
// shear. The degrees of freedom of a node are u_x, u_y, u_z, ψ_y, ψ_z, where ψ is the rotation of the
// section, counted as a slope: without shear, ψ_y = du_y/dx and ψ_z = du_z/dx. A fibre at (y, z) moves by u_x
// − y ψ_y − z ψ_z.
//
// Bending interpolates with the exact static solution of the unloaded Timoshenko beam (Przemieniecki 1968;
// Friedman and Kosmatka 1993), φ = 12 EI/(G A_s l²); for φ = 0 this is Hermite's cubic. The element therefore
// does not lock, serves for both theories, and gives exact nodal values under loads at nodes.
#pragma once

#include <array>

#include "simplified/beam/elements/block_tridiagonal.hpp"
#include "simplified/beam/model/tunnel.hpp"

namespace adit::simplified::beam {

using ElementMatrix = Eigen::Matrix<double, 2 * kDofs, 2 * kDofs, Eigen::RowMajor>;

// Degrees of freedom of one plane within the element's ten: w₁, ψ₁, w₂, ψ₂.
inline constexpr std::array<int, 4> kLateralDofs = {1, 3, 6, 8}, kVerticalDofs = {2, 4, 7, 9};
inline constexpr std::array<int, 2> kAxialDofs = {0, 5};

struct BendingPlane {
  double rigidity = 0;      // EI [N m²]
  double shear_factor = 0;  // φ
};

struct Shape {
  std::array<double, 4> deflection, rotation;  // at a point, for unit w₁, ψ₁, w₂, ψ₂
};

// The shape functions at ξ in [0, 1] of an element of this length.
Shape shape(const BendingPlane& plane, double length, double xi);

class Element {
 public:
  Element(const Section& section, double length);

  double length() const { return length_; }
  const BendingPlane& plane(Direction d) const { return planes_[d == kVertical]; }
  ElementMatrix stiffness() const;
  ElementMatrix mass() const;  // consistent; with rotary inertia if the section has shear
  Eigen::Matrix<double, 2 * kDofs, 1> load() const;  // consistent nodal forces of the section's static load

 private:
  const Section* section_;
  double length_;
  std::array<BendingPlane, 2> planes_;  // lateral, vertical
};

// Gauss–Legendre points on [0, 1].
struct QuadraturePoint {
  double xi, weight;
};
inline constexpr double kThree = 0.3872983346207417, kFourOuter = 0.4305681557970263,
                        kFourInner = 0.1699905217924281;
inline constexpr std::array<QuadraturePoint, 3> kThreePoints = {
    {{0.5 - kThree, 5. / 18}, {0.5, 8. / 18}, {0.5 + kThree, 5. / 18}}};
inline constexpr std::array<QuadraturePoint, 4> kFourPoints = {{{0.5 - kFourOuter, 0.1739274225687269},
                                                                {0.5 - kFourInner, 0.3260725774312731},
                                                                {0.5 + kFourInner, 0.3260725774312731},
                                                                {0.5 + kFourOuter, 0.1739274225687269}}};

}  // namespace adit::simplified::beam
