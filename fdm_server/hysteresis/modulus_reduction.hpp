// How the secant shear modulus falls with the shear strain, and the backbone that follows from it.
//
// The vertices lie on the curve, the strain growing by a factor r from one to the next. For a hyperbola the
// chords then miss at most (r - 1)^2/16 of the stress, and of the damping of small loops (r - 1)^3/(r^3 - 1):
// 0.2 % and 0.7 % for r = 1.155.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace adit::fdm {

// Secant shear modulus over the initial one, by engineering shear strain.
using ModulusReduction = std::function<double(double shear_strain)>;

// 1 / (1 + (strain / reference)^exponent).
ModulusReduction hyperbola(double reference_strain, double exponent);

// Through the points, a monotone cubic (Fritsch & Carlson 1980) over the logarithm of the strain; constant
// beyond them. `strains` increase, at least two.
std::function<double(double shear_strain)> smooth_table(std::span<const double> strains,
                                                        std::span<const double> values);

// The share of Masing's damping in loops of ground with that reduction after so many cycles, (0.6329 - 0.0057
// ln(cycles)) (G/G0)^0.1 (Darendeli 2001).
std::function<double(double shear_strain)> darendeli_share(const ModulusReduction& reduction, double cycles);

struct BackbonePoint {
  double strain, stress;  // engineering shear strain; shear stress over the initial modulus
};

// `elements` vertices between the strains, equally spaced by logarithm; the first lies on the initial
// tangent. Where the stress of the curve would stiffen or fall, the backbone is its concave hull.
std::vector<BackbonePoint> backbone(const ModulusReduction& reduction, double first_strain,
                                    double last_strain, std::size_t elements);

}  // namespace adit::fdm
