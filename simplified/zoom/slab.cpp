#include "simplified/zoom/slab.hpp"

#include <algorithm>
#include <cmath>

#include "simplified/beam/elements/joint_springs.hpp"

namespace adit::simplified {
namespace {

// Stiffness at rest: the mean slope over a millimetre on both sides.
double slope(const beam::Curve& curve) {
  constexpr double kStep = 1e-3;
  return curve.points.empty() ? 0 : (curve.force(kStep) - curve.force(-kStep)) / (2 * kStep);
}

double inverse(double stiffness) {
  return stiffness > 0 ? 1 / stiffness : 0;
}

// Of a length of lining and joints: EA [N], EI [N m^2], G A_s [N]; 0 without shear deformation.
struct Stiffness {
  double axial, bending, shear;
};

Stiffness jointed(const scene::Section& section, std::span<const beam::Joint> joints, double length) {
  const double E = section.young_modulus();
  double axial = length / (E * section.area()), bending = length / (E * section.lateral_inertia());
  double shear = length * inverse(E / (2 * (1 + section.poisson_ratio())) * section.shear_area());
  for (const beam::Joint& joint : joints) {
    double k = 0, turning = 0;
    for (const auto& spring : beam::axial_springs(joint)) {
      k += slope(spring.curve);
      turning += slope(spring.curve) * spring.y * spring.y;
    }
    axial += inverse(k);
    bending += inverse(turning);
    shear += inverse(slope(joint.lateral));
  }
  return {length / axial, length / bending, length * inverse(shear)};
}

}  // namespace

Slab slab_of(const scene::Section& section) {
  const double width = std::sqrt(12 * section.lateral_inertia() / section.area());
  return {width, section.young_modulus() * section.area() / width, section.poisson_ratio(),
          section.mass() / width};
}

JointedSlab spread(const scene::Section& section, const Slab& slab, std::span<const beam::Joint> joints,
                   double length) {
  const Stiffness wanted = jointed(section, joints, length);
  const double mean = wanted.axial / slab.width;
  // Both moduli stay positive between a quarter and seven quarters of the mean.
  const double bending = std::clamp(12 * wanted.bending / std::pow(slab.width, 3), 0.3 * mean, 1.7 * mean);
  const double poisson =
      wanted.shear > 0 ? 5. / 6 * wanted.axial / (2 * wanted.shear) - 1 : section.poisson_ratio();
  return {(7 * mean - 4 * bending) / 3, (4 * bending - mean) / 3, std::clamp(poisson, -0.5, 0.3)};
}

}  // namespace adit::simplified
