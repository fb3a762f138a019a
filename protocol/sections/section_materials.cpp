#include "protocol/sections/section_materials.hpp"

#include <algorithm>
#include <cmath>

namespace adit::sections {
namespace {

using protocol::Standard;

constexpr double kBonded = 0.6;  // k_t of EN 1992-1-1, 7.3.4

// EN 1992-1-1, table 3.1; of a mean strength.
double strain_at_peak(double mean) {
  return std::min(0.7 * std::pow(mean / 1e6, 0.31), 2.8) / 1000;
}

}  // namespace

ConcreteValues concrete_values(const protocol::Concrete& of, Values values) {
  const bool eurocode = of.standard == Standard::kEurocode;
  const double peak = strain_at_peak(of.compressive_strength);
  const auto diagram = [&](double strength) {
    return eurocode ? eurocode_diagram(strength, of.characteristic_compressive / 1e6)
                    : chinese_diagram(strength, of.cube / 1e6);
  };
  const auto [young_modulus, compressive, tensile, factor] = protocol::concrete_strengths(of, values);
  const double cylinder = values == Values::kMean ? of.compressive_strength : of.characteristic_compressive;
  return {young_modulus, compressive, tensile, peak, diagram(compressive), cylinder, factor};
}

ConcreteValues concrete_values(double young_modulus, double compressive, double tensile) {
  return {young_modulus,
          compressive,
          tensile,
          strain_at_peak(compressive),
          eurocode_diagram(compressive, compressive / 1e6),
          compressive,
          1};
}

ConcreteLaw concrete_law(const ConcreteValues& concrete, double tension_end,
                         const ResidualTension& residual) {
  // The slope of eq. 3.14 at the origin.
  return {1.05 * concrete.young_modulus,
          concrete.compressive,
          concrete.peak_strain,
          concrete.tensile,
          tension_end,
          residual,
          kBonded};
}

CapacityMaterials capacity_materials(const ConcreteValues& concrete, const SteelValues& steel,
                                     const ResidualTension& residual) {
  return {concrete.diagram, steel.young_modulus, steel.yield, steel.limit_strain, residual};
}

ShearMaterials shear_materials(const ConcreteValues& concrete, const SteelValues& steel, double stirrups) {
  return {concrete.cylinder, concrete.partial_factor, concrete.compressive, steel.yield, stirrups};
}

}  // namespace adit::sections
