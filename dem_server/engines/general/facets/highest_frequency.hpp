// How fast a body of cells can oscillate.
//
// omega^2 is the largest eigenvalue of M^-1 K, K being the stiffness of all intact facets with the changes of
// the cells' areas. It is found by power iteration: the quotient of Rayleigh grows towards it, the more
// slowly the nearer it is. What it may lack when it has all but stopped growing is added. A bound by single
// facets, as for discs, would be a half to four times too large: it lets every facet of a cell, its turn and
// the change of its area act against each other at once.
//
// Facets that break leave others as they are, and a cell touches another one only where it has no facet:
// breaking makes a body softer.
#pragma once

#include "dem_server/model/model.hpp"
#include "dem_server/particles/particles.hpp"

namespace adit::dem {

// omega^2 [1/s^2], without energy weights; 0 without facets.
double highest_square_of_facets(const Model& model, const Masses& masses);

}  // namespace adit::dem
