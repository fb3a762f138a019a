// Bars through particles, from the scene.
//
// Bond: tau_max = 2.5 sqrt(f_c / MPa) MPa (fib Model Code 2010, table 6.1-1, pull-out, good bond conditions).
// Dowel: a bar across a crack is a beam on the concrete at both sides, of the foundation modulus
//   k_f = 127 sqrt(f_c / MPa) / (d / mm)^(2/3) MPa/mm      (Soroushian, Obaseki & Rojas 1987, ACI Struct. J.
//   84, 76),
// so that the shift D of the faces makes the force E I lambda^3 D with lambda = (k_f d / 4 E I)^(1/4)
// (Timoshenko); it is at most
//   V_u = 1.3 d^2 sqrt(f_c f_y)                            (Vintzeleou & Tassios 1987, ACI Struct. J. 84,
//   18).
#pragma once

#include <vector>

#include "dem_server/model/bars.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/model/placement/groups.hpp"

namespace adit::dem {

// Of a model whose discs, outlines and groups are there. UserError for bars that lie in no or one particle,
// or leave the particles; whose steel or concrete is not stated once.
std::vector<Bar> read_bars(const scene::Particles& particles, const std::vector<Group>& groups,
                           const Model& model);

}  // namespace adit::dem
