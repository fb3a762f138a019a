// Central differences: displacements at n from velocities at n - 1/2, velocities at n + 1/2 from forces at n.
#pragma once

#include "dem_server/assembly.hpp"

namespace adit::dem {

// u += dt v
void move(double dt, Particles& particles);

// v += dt f / m and spin += dt moment / J; half of dt in the first step, from rest.
void kick(double dt, Particles& particles);

}  // namespace adit::dem
