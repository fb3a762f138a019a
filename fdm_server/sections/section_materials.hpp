// Strengths of concrete and steel, by class or by numbers, and the laws that follow.
//
// Of a class, mean values are those of protocol/materials. Design values (EN 1992-1-1:2004, 3.1.6, 3.2.7):
//   f_cd = f_ck/1.5, f_ctd = f_ctk,0.05/1.5, E_cd = E_cm/1.2 (5.8.6 (3)), f_yd = f_yk/1.15
// with alpha_cc = alpha_ct = 1. GB 50010-2010, 4.1.4: f_c = f_ck/1.4, f_t = f_tk/1.4.
// Numbers are taken as they are, with the strains of EN 1992-1-1 for their compressive strength.
#pragma once

#include "fdm_server/sections/capacity.hpp"
#include "fdm_server/sections/concrete_law.hpp"
#include "fdm_server/sections/fibre_concrete.hpp"
#include "fdm_server/sections/shear_capacity.hpp"
#include "protocol/materials/concrete.hpp"
#include "protocol/materials/read_steel.hpp"

namespace adit::fdm {

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

}  // namespace adit::fdm
