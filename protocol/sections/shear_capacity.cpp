#include "protocol/sections/shear_capacity.hpp"

#include <algorithm>
#include <cmath>

namespace adit::sections {
namespace {

// The bars on the stretched side.
struct TensionBars {
  double area = 0, depth = 0;  // [m^2]; d of their centre [m]
};

TensionBars tension_bars(const SectionShape& shape, Bending bending) {
  const double outwards = bending == Bending::kOuterStretched ? 1 : -1;
  TensionBars sum;
  for (const BarLayer& bars : shape.bars) {
    if (outwards * bars.position <= 0) continue;
    sum.area += bars.area;
    sum.depth += bars.area * (shape.thickness / 2 + outwards * bars.position);
  }
  sum.depth = sum.area > 0 ? sum.depth / sum.area : 0.9 * shape.thickness;
  return sum;
}

double without_stirrups(const SectionShape& shape, const ShearMaterials& of, const TensionBars& bars,
                        double thrust) {
  const double strength = of.cylinder_strength / 1e6, size = std::min(1 + std::sqrt(0.2 / bars.depth), 2.0),
               ratio = std::min(bars.area / (shape.width * bars.depth), 0.02),
               pressure = std::min(-thrust / (shape.width * shape.thickness), 0.2 * of.design_strength);
  const double bars_carry = 0.18 / of.partial_factor * size * std::cbrt(100 * ratio * strength),
               least = 0.0525 / of.partial_factor * std::pow(size, 1.5) * std::sqrt(strength);
  const double stress = 1e6 * std::max(bars_carry, least) + 0.15 * pressure;
  return std::max(stress, 0.0) * shape.width * bars.depth;
}

double with_stirrups(const SectionShape& shape, const ShearMaterials& of, const TensionBars& bars) {
  const double z = 0.9 * bars.depth, reduction = 0.6 * (1 - of.cylinder_strength / 250e6);
  const double steel = of.stirrup_area * z * of.stirrup_yield,
               struts = shape.width * z * reduction * of.design_strength;
  // Equal where sin^2 theta = steel / struts.
  const double sine = std::clamp(steel / struts, 1 / (1 + 2.5 * 2.5), 0.5),
               cotangent = std::sqrt(1 / sine - 1);
  return std::min(steel * cotangent, struts / (cotangent + 1 / cotangent));
}

}  // namespace

double shear_capacity(const SectionShape& shape, const ShearMaterials& materials, Bending bending,
                      double thrust) {
  const TensionBars bars = tension_bars(shape, bending);
  const double concrete = without_stirrups(shape, materials, bars, thrust);
  return materials.stirrup_area > 0 ? std::max(concrete, with_stirrups(shape, materials, bars)) : concrete;
}

}  // namespace adit::sections
