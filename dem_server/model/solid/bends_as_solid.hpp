// The scene's wish that a packing bends as the solid (thin_strip.hpp).
#pragma once

#include "dem_server/model/model.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// Does what `particles.packing.bends_as_solid` asks for and says so in the model's notes. UserError where the
// packing is no full rectangle of at least three rows, all joined by contact bonds of one law, or starts
// under a stress.
void bend_as_solid(const scene::Scene& scene, Model& model);

}  // namespace adit::dem
