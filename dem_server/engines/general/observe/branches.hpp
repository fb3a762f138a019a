// What holds a solver's discs together and carries forces through them, for fragments.hpp and circles.hpp.
#pragma once

#include <vector>

#include "dem_server/engines/general/observe/circles.hpp"
#include "dem_server/engines/general/solver.hpp"
#include "dem_server/packing/discs.hpp"

namespace adit::dem {

// Discs that a whole bond joins.
std::vector<Pair> whole_bonds(const Solver& solver);
// These, and discs that touch otherwise.
std::vector<Pair> touching_discs(const Solver& solver);

// Forces of bonds, contacts, joints, springs and walls as they are, without energy weights and dashpots; a
// wall's branch ends where the disc touches it.
std::vector<Branch> branches_of(const Solver& solver);

}  // namespace adit::dem
