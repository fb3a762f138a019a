// What acts on particles: loads, prescribed motions.
#pragma once

#include <string>
#include <vector>

#include "dem_server/model/model.hpp"
#include "dem_server/model/placement/placement.hpp"

namespace adit::dem {

// UserError at `path` for a function that cannot be evaluated.
TimeFactor factor_of(const scene::TimeFunction& function);

// Loads, then body loads. UserError at particles.loads[i] and particles.body_loads[i] that select nothing.
std::vector<Load> read_loads(const scene::Particles& particles, const Placement& placement);

// UserError at particles.motions[i]: nothing prescribed, nothing selected, or a component that another motion
// prescribes too.
std::vector<PrescribedMotion> read_motions(const scene::Particles& particles, const Placement& placement);

// Refused beside particles of later stages: a foundation holds what is there from the beginning.
std::vector<Foundation> read_foundations(const scene::Particles& particles, const Placement& placement);

}  // namespace adit::dem
