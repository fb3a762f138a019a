// Strengths of bonds from the tensile strength f_t, the cohesion c and the friction angle phi of a material.
//
// Contact bonds of the hexagonal lattice. A uniform stress s along the rows, where f_t and the unconfined
// compressive strength UCS are matched, loads the bonds (initial_state.hpp) along the rows by
//   N = s R (3 kn + ks) / (sqrt(3) (kn + ks)),
// and the slanting ones in shear by S = s R ks / (kn + ks), R being the radius. Hence the tensile strength
// N(f_t) and the shear strength S(UCS), UCS = 2 c cos(phi) / (1 - sin(phi)). Along the rows the lattice is
// weakest in tension: across them its first bonds break at f_t (3 kn + ks) / (2 kn + ks). A contact bond's
// shear strength knows no friction; only the contact that it leaves can have it. What the laboratory finds
// stands in docs/particles.md.
//
// Parallel bonds take f_t, c and phi as the strengths of their cement. What a packing of them gives in the
// laboratory is another matter (docs/particles.md).
#pragma once

#include <optional>
#include <string>

#include "dem_server/laws/contact_bond.hpp"
#include "dem_server/laws/parallel_bond.hpp"
#include "dem_server/model/placement/scene_checks.hpp"

namespace adit::dem {

struct MaterialStrength {
  double tension, cohesion, friction_angle;  // [Pa], [Pa], [rad]
};

// UserError at `path` where the material has no mohr_coulomb, or no tensile strength or cohesion.
MaterialStrength strength_of(const MaterialAt& material, const std::string& path);

// Where the material states a tension that its cone cuts by more than 1 %, which strength_of() then does: a
// sentence with both numbers.
std::optional<std::string> note_on_cut_tension(const MaterialAt& material);

// The smaller of each.
MaterialStrength weaker(const MaterialStrength& a, const MaterialStrength& b);

// The law with these strengths: of a hexagonal lattice of discs of this radius [m] …
ContactBond with_strength(const MaterialStrength& strength, double radius, const ContactBond& law);
// … and of cement.
ParallelBond with_strength(const MaterialStrength& strength, const ParallelBond& law);

}  // namespace adit::dem
