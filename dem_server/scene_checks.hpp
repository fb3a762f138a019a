// What the particle part of a scene must fulfil beyond the limits of single fields.
#pragma once

#include "dem_server/contact_forces.hpp"
#include "dem_server/packing/hexagonal.hpp"
#include "protocol/scene.pb.h"

namespace adit::dem {

// The particles' own material, or the scene's.
const scene::Material& material_of(const scene::Scene& scene);

// The packing that the scene asks for. UserError at particles.packing: no box, no particles, too many.
Packing checked_packing(const scene::Scene& scene);

// Stiffnesses (calibrated, or the scene's own) and strengths. UserError at material or particles.bonds.
BondLaw checked_bond_law(const scene::Scene& scene);

}  // namespace adit::dem
