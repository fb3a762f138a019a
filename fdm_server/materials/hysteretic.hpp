// Strain-dependent shear modulus with hysteretic damping: Iwan's parallel elements (Iwan 1967, J. Appl. Mech.
// 34).
//
// The stress deviator is the sum of N elastic, perfectly plastic elements (von Mises) that all have the
// strain of the ground. Element i has the shear modulus G_i and yields at the shear strain x_i. In simple
// shear the sum is the polyline backbone of slopes H_k = sum over i > k of G_i; unloading and reloading from
// any reversal follow that backbone doubled, and meet earlier branches as Masing's extended rules say,
// because each element must be driven back twice its yield strain: the rules are a consequence, for every
// strain path in the plane and across it. Each element dissipates, hence so does the sum. The volume changes
// elastically.
//
// The vertices lie on the curve, the strain growing by a factor r from one to the next. For a hyperbola the
// chords then miss at most (r - 1)^2/16 of the stress, and of the damping of small loops (r - 1)^3/(r^3 - 1):
// 0.2 % and 0.7 % for r = 1.155.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "fdm_server/materials/solid.hpp"

namespace adit::fdm {

// Secant shear modulus over the initial one, by engineering shear strain.
using ModulusReduction = std::function<double(double shear_strain)>;

// 1 / (1 + (strain / reference)^exponent).
ModulusReduction hyperbola(double reference_strain, double exponent);
// Through the points, a monotone cubic (Fritsch & Carlson 1980) over the logarithm of the strain; constant
// beyond them. `strains` increase, at least two.
ModulusReduction reduction_table(std::span<const double> strains, std::span<const double> ratios);

struct BackbonePoint {
  double strain, stress;  // engineering shear strain; shear stress over the initial modulus
};

// `elements` vertices between the strains, equally spaced by logarithm; the first lies on the initial
// tangent. Where the stress of the curve would stiffen or fall, the backbone is its concave hull.
std::vector<BackbonePoint> backbone(const ModulusReduction& reduction, double first_strain,
                                    double last_strain, std::size_t elements);

class Hysteretic {
 public:
  explicit Hysteretic(std::vector<BackbonePoint> backbone);

  // Shear stress over the initial modulus in first loading.
  double stress(double shear_strain) const;
  // Damping ratio of Masing's closed loops between -strain and +strain: dissipated energy over 4 pi times the
  // elastic energy of the secant, with A the area under the backbone, 2/pi (2 A/(tau strain) - 1).
  double damping_ratio(double shear_strain) const;
  std::span<const BackbonePoint> backbone() const { return backbone_; }

  // State of one point: the deviator (xx - yy)/2, xy, zz of each element in turn, then the same of the
  // initial stress, which the elements do not see, then the strains xx - yy, xy, xx + yy since.
  std::size_t values() const { return 3 * (elements_.size() + 2); }
  void set_stress(std::span<double> state, const SolidStress& stress) const;
  // Adds the strain; returns the energy per volume that the elements dissipated, >= 0.
  double add(const Elasticity& elasticity, const Strain& strain, std::span<double> state,
             SolidStress& stress) const;
  // Turns the state with the ground.
  void turn(std::span<double> state, double cosine, double sine) const;
  // Energy per volume; that of the initial stress over the strains since included.
  double energy(const Elasticity& elasticity, std::span<const double> state, const SolidStress& stress) const;
  // Whether any element is at its limit.
  bool yields(const Elasticity& elasticity, std::span<const double> state) const;

 private:
  struct Element {
    double stiffness, strength;  // over the initial modulus
  };
  std::vector<BackbonePoint> backbone_;
  std::vector<Element> elements_;
};

}  // namespace adit::fdm
