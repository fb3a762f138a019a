#include "simplified/beam/elements/element.hpp"

namespace adit::simplified::beam {
namespace {

BendingPlane bending_plane(double rigidity, double shear_rigidity, double length) {
  return {rigidity, shear_rigidity > 0 ? 12 * rigidity / (shear_rigidity * length * length) : 0};
}

}  // namespace

Shape shape(const BendingPlane& plane, double length, double xi) {
  const double phi = plane.shear_factor, f = 1 / (1 + phi), x2 = xi * xi, x3 = x2 * xi;
  const double bulge = 6 * f * (x2 - xi) / length;
  return {{f * (2 * x3 - 3 * x2 - phi * xi + 1 + phi),
           f * length * (x3 - (2 + phi / 2) * x2 + (1 + phi / 2) * xi), -f * (2 * x3 - 3 * x2 - phi * xi),
           f * length * (x3 - (1 - phi / 2) * x2 - phi / 2 * xi)},
          {bulge, f * (3 * x2 - (4 + phi) * xi + 1 + phi), -bulge, f * (3 * x2 - (2 - phi) * xi)}};
}

Element::Element(const Section& section, double length)
    : section_(&section),
      length_(length),
      planes_{bending_plane(section.youngs_modulus * section.inertia_lateral,
                            section.shear_modulus * section.shear_area_lateral, length),
              bending_plane(section.youngs_modulus * section.inertia_vertical,
                            section.shear_modulus * section.shear_area_vertical, length)} {}

ElementMatrix Element::stiffness() const {
  ElementMatrix k = ElementMatrix::Zero();
  const double axial = section_->youngs_modulus * section_->area / length_, l = length_;
  for (int i : {0, 1})
    for (int j : {0, 1}) k(kAxialDofs[i], kAxialDofs[j]) = i == j ? axial : -axial;
  for (const Direction d : {kLateral, kVertical}) {
    const auto& dofs = d == kLateral ? kLateralDofs : kVerticalDofs;
    const double phi = plane(d).shear_factor, b = plane(d).rigidity / ((1 + phi) * l * l * l);
    const double bending[4][4] = {{12, 6 * l, -12, 6 * l},
                                  {6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l},
                                  {-12, -6 * l, 12, -6 * l},
                                  {6 * l, (2 - phi) * l * l, -6 * l, (4 + phi) * l * l}};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) k(dofs[i], dofs[j]) = b * bending[i][j];
  }
  return k;
}

ElementMatrix Element::mass() const {
  ElementMatrix m = ElementMatrix::Zero();
  for (int i : {0, 1})
    for (int j : {0, 1}) m(kAxialDofs[i], kAxialDofs[j]) = section_->mass * length_ / (i == j ? 3 : 6);
  const double density = section_->mass / section_->area;
  for (const Direction d : {kLateral, kVertical}) {
    const auto& dofs = d == kLateral ? kLateralDofs : kVerticalDofs;
    const double inertia = d == kLateral ? section_->inertia_lateral : section_->inertia_vertical;
    // The theory of Euler and Bernoulli neglects rotary inertia together with shear, that of Timoshenko has
    // both.
    const double rotary = plane(d).shear_factor > 0 ? density * inertia : 0;
    for (const auto& point : kFourPoints) {  // products of cubics: exact
      const Shape s = shape(plane(d), length_, point.xi);
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          m(dofs[i], dofs[j]) +=
              point.weight * length_ *
              (section_->mass * s.deflection[i] * s.deflection[j] + rotary * s.rotation[i] * s.rotation[j]);
    }
  }
  return m;
}

Eigen::Matrix<double, 2 * kDofs, 1> Element::load() const {
  Eigen::Matrix<double, 2 * kDofs, 1> p = Eigen::Matrix<double, 2 * kDofs, 1>::Zero();
  for (const int dof : kAxialDofs) p[dof] = section_->load[kAxial] * length_ / 2;
  for (const Direction d : {kLateral, kVertical}) {
    const auto& dofs = d == kLateral ? kLateralDofs : kVerticalDofs;
    // Three points integrate the cubic shape functions under a uniform load exactly.
    for (const auto& point : kThreePoints) {
      const Shape s = shape(plane(d), length_, point.xi);
      for (int i = 0; i < 4; ++i) p[dofs[i]] += point.weight * length_ * section_->load[d] * s.deflection[i];
    }
  }
  return p;
}

}  // namespace adit::simplified::beam
