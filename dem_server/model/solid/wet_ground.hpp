// Particles of ground whose pores hold water. No water flows between them, so that they move without
// drainage, in statics too, and bear the total stress. A material with pores stands for the skeleton and the
// water in it, as if grains did not yield (Gassmann 1951):
//   K_u = K + K_w / n,   G_u = G,   and the density of the saturated ground.
// Cells are at most as incompressible as by their largest Poisson's ratio; they then take softer water.
// Without a modulus of the water its pressure never changes, and stiffness is that of the skeleton.
#pragma once

#include <string>
#include <vector>

#include "dem_server/model/initial_state/outside.hpp"
#include "dem_server/model/model.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// Fills the pores of the materials that the particles of the scene have, where it has water. Returns what the
// user should know. UserError for discs, whose bonds cannot be so incompressible.
std::vector<std::string> fill_pores(scene::Scene& scene);

// Then: UserError if particles with pores lie above the water, or where it has another level or pressure than
// elsewhere.
void require_in_water(const scene::Scene& scene, const Model& model);

// The stress that the scene states; where particles have pores with k0 of the effective one.
StressAt stated_stress(const scene::Scene& scene);

}  // namespace adit::dem
