// Bonds whose stiffness and strength differ from place to place (materials.proto: Scatter).
//
// A bond takes the factors where its particles meet, in all stages: contact bonds and the cement of parallel
// bonds in their stiffnesses, tensile and shear strengths. A cell takes the stiffness factor at its nucleus,
// and a facet stands for half of each of its cells, in series; the facet's strengths take their factor where
// the nuclei meet. Its energies of fracture stay, and so do smooth joints and contacts.
#pragma once

#include "dem_server/model/model.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// UserError at `particles.scatter` for a field that cannot be read.
void scatter(const scene::Particles& particles, Model& model);

}  // namespace adit::dem
