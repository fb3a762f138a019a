// Strengths of concrete and steel, by class or by numbers, and the laws that follow.
//
// Those of a class are in protocol/materials. Numbers are taken as they are, with the strains of EN 1992-1-1
// for their compressive strength.
#pragma once

#include "protocol/materials/read_concrete.hpp"
#include "protocol/materials/read_steel.hpp"
#include "protocol/sections/capacity.hpp"
#include "protocol/sections/concrete_law.hpp"
#include "protocol/sections/fibre_concrete.hpp"
#include "protocol/sections/shear_capacity.hpp"

namespace adit::sections {

using protocol::steel_law;
using protocol::steel_values;
using protocol::SteelLaw;
using protocol::SteelValues;
using protocol::Values;

struct ConcreteValues {
  double young_modulus, compressive, tensile;  // [Pa]
  double peak_strain;                          // eps_c1
  ParabolaRectangle diagram;
  double cylinder, partial_factor;  // for shear: f [Pa] and gamma_c
};
ConcreteValues concrete_values(const protocol::Concrete& of, Values values);
ConcreteValues concrete_values(double young_modulus, double compressive, double tensile);

// Between its cracking and `tension_end`, a strain, concrete loses its tension: bars whose bond lets it carry
// do so until they yield. `residual`: of fibres.
ConcreteLaw concrete_law(const ConcreteValues& concrete, double tension_end,
                         const ResidualTension& residual = {});
CapacityMaterials capacity_materials(const ConcreteValues& concrete, const SteelValues& steel,
                                     const ResidualTension& residual = {});
// `stirrups`: A_sw/s over the section's width.
ShearMaterials shear_materials(const ConcreteValues& concrete, const SteelValues& steel, double stirrups);

}  // namespace adit::sections
