// What holds particles together and carries forces through them, for fragments.hpp and circles.hpp.
#pragma once

#include <vector>

#include "dem_server/observe/observable.hpp"
#include "dem_server/packing/discs.hpp"

namespace adit::dem {

// Particles that a whole bond joins.
std::vector<Pair> whole_bonds(const Observable& observed);
// These, and particles that touch otherwise.
std::vector<Pair> touching_particles(const Observable& observed);

// Forces of bonds, contacts, joints, springs and walls as they are, without energy weights and dashpots; a
// wall's branch ends where the particle touches it.
std::vector<Branch> branches_of(const Observable& observed);

}  // namespace adit::dem
