// What links can bear: strengths of bonds, and surfaces that only press and rub.
#pragma once

#include "dem_server/model/model.hpp"

namespace adit::dem {

// Gives a bond or a pair that touches its forces at rest: of the wanted ones what it can bear, which is
// returned. A parallel bond and the contact beside it share them by stiffness, as far as the contact can.
PairForces bear(const Model& model, const PairForces& wanted, Bond& bond);
PairForces bear(const Model& model, const PairForces& wanted, TouchingPair& pair);

}  // namespace adit::dem
