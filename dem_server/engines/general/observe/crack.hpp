// Geometry of the crack that a broken bond leaves, in the body at rest: across the bond, where the discs
// touched. As long as the cement of a parallel bond is wide; of a contact bond the edge of the hexagonal cell
// of its smaller disc, 2 R / sqrt(3) (crack.hpp).
#pragma once

#include <cstdint>

#include "dem_server/engines/general/solver.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/participant/crack.hpp"

namespace adit::dem {

// The middle of the discs' gap at rest, where they meet.
Place middle_of(const Discs& discs, std::uint32_t first, std::uint32_t second);

Crack crack_of_bond(const Model& model, const Solver& solver, std::uint32_t bond);

}  // namespace adit::dem
