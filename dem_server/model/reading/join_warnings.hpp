// What is likely to be wrong with the bonds of a model.
#pragma once

#include <string>
#include <vector>

#include "dem_server/model/reading/join.hpp"

namespace adit::dem {

// One sentence each, where
// - many pairs are left without a bond by a gap that the rounding of their places may have opened;
// - rows of particles interlock across an open joint, which then does not slide as a plane.
std::vector<std::string> join_warnings(const scene::Particles& particles, const Joined& joined,
                                       const Reach& reach);

}  // namespace adit::dem
