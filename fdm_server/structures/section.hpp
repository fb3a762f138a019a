// What a beam's section resists with, per metre of thickness of the plane.
#pragma once

#include <limits>

namespace adit::fdm {

struct Section {
  double axial;    // E A [N]
  double bending;  // E I [N m^2]
  double shear;    // G A_s [N]; infinite: sections stay at right angles to the axis (Euler-Bernoulli)
  double mass;     // rho A [kg/m]
  double rotary;   // rho I [kg m]
};

// A lining's material. In plane strain E / (1 - nu^2) replaces E, because the lining cannot strain along the
// tunnel; the shear modulus E / (2 (1 + nu)) stays.
struct LiningMaterial {
  double young;  // E, or E / (1 - nu^2) [Pa]
  double shear;  // G [Pa]
  double density;
};
inline LiningMaterial lining_material(bool plane_strain, double young, double poisson, double density) {
  return {plane_strain ? young / (1 - poisson * poisson) : young, young / (2 * (1 + poisson)), density};
}

// A section of area A and moment of inertia I; 5/6 of the area carries shear, as in a rectangle.
inline Section make_section(const LiningMaterial& material, double area, double inertia,
                            bool shear_flexible) {
  constexpr double kShearShare = 5.0 / 6;
  return {material.young * area, material.young * inertia,
          shear_flexible ? kShearShare * material.shear * area : std::numeric_limits<double>::infinity(),
          material.density * area, material.density * inertia};
}

}  // namespace adit::fdm
