// The model of discs that a scene describes.
#pragma once

#include "dem_server/discs/model.hpp"

namespace adit::dem {

// Whether the particles have any feature beyond a hexagonal packing with contact bonds and frictionless
// contacts.
bool needs_discs(const scene::Particles& particles);

// protocol::UserError at the field that cannot be computed.
Model read_model(const scene::Scene& scene);

}  // namespace adit::dem
