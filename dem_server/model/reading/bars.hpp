// Bars through particles, from the scene.
//
// Bond: tau_max = 2.5 sqrt(f_c / MPa) MPa (fib Model Code 2010, table 6.1-1, pull-out, good bond conditions).
// Dowel: a bar across a crack is a beam on the concrete at both sides, of the foundation modulus
//   k_f = 127 sqrt(f_c / MPa) / (d / mm)^(2/3) MPa/mm      (Soroushian, Obaseki & Rojas 1987, ACI Mater. J.
//   84, 179, for bars far apart),
// so that the shift D of the faces makes the force E I lambda^3 D with lambda = (k_f d / 4 E I)^(1/4)
// (Timoshenko). The concrete beside the crack bears 5 f_c d on a length at whose end the bar yields in
// bending, with M_p = d^3 f_y/6 (Rasmussen 1963): V_u^2/(2 * 5 f_c d) = M_p, so that
//   V_u = 1.3 d^2 sqrt(f_c f_y)
// in the form of Vintzeleou & Tassios (1986, Mag. Concrete Res. 38). An axial stress sigma leaves of M_p the
// share 1 - (sigma/f_y)^2, as in a rectangle.
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
