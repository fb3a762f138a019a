// Facets between cells from a material (laws/facet.hpp, engines/general/facets/facet_kernel.hpp).
//
// With the constants of the plane, E2 = E and nu2 = nu in plane stress, E / (1 - nu^2) and nu / (1 - nu) in
// plane strain: E' = E2 / (1 + nu2) = 2 G, and lambda = E2 nu2 / (1 - nu2^2).
//
// A stated compressive strength f_c gives the cohesion by Mohr and Coulomb, c = f_c (1 - sin phi) / (2 cos
// phi).
#pragma once

#include <string>

#include "dem_server/model/model.hpp"
#include "dem_server/model/placement/scene_checks.hpp"

namespace adit::dem {

inline constexpr double kLargestPoissonRatio = 0.45;  // of cells, which deform like a solid up to there

// UserError below the material's path for a Poisson's ratio that cells do not reach.
CellElasticity elasticity_of(const MaterialAt& material, Plane plane);

// UserError below `path` for strengths of which the compressive one is not the larger, or is not stated or
// stated twice.
FacetLaw fracture_of(const scene::Fracture& fracture, const std::string& path);
// 2 c cos(phi) / (1 - sin(phi)) [Pa]
double compressive_strength(const FacetLaw& law);
// Of cells of this stiffness E' [Pa] that only touch, with this friction: what strength it has is a billionth
// of the stiffness.
FacetLaw touching(double stiffness, double friction);
// That never breaks.
FacetLaw unbroken();
// The smaller of each.
FacetLaw weaker(const FacetLaw& a, const FacetLaw& b);

}  // namespace adit::dem
