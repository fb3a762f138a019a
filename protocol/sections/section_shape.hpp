// A rectangular section with layers of bars.
//
// z runs from the middle of the thickness to the outer face: to the right of a lining's path. Strains and
// stresses are positive in tension; eps(z) = eps_0 + kappa z, N = sum of forces, M = sum of forces times z,
// so that a positive moment stretches the outer face, as in structures/beam.hpp. Plane sections stay plane.
#pragma once

#include <cstddef>
#include <vector>

namespace adit::sections {

struct BarLayer {
  double position;  // z [m]
  double area;      // of all its bars [m^2]
  double diameter;  // of one [m]
};

struct SectionShape {
  double thickness, width;  // [m]
  std::vector<BarLayer> bars;
};

struct ConcreteLayer {
  double position, area;  // z of its middle [m], [m^2]
};

// Layers of concrete of equal thickness, from the inner face; bars displace the concrete of the layer in
// which they lie.
std::vector<ConcreteLayer> concrete_layers(const SectionShape& shape, std::size_t count);

struct SectionForces {
  double thrust, moment;  // N [N], M [N m], per width of the section
};

}  // namespace adit::sections
