// Tunnels whose linings are beams or zones of the continuum.
//
// The grid around each becomes blocks of zones that follow its opening (opening.hpp). Beams lie on the axis
// of the first layer, half of its thickness inside the ground: there the zones end, or are excavated in the
// tunnel's stage. Each further layer lies on the one before. Layers of zones are rings of zones between their
// own faces. Displacements are recorded as `<tunnel>_crown`, `_invert`, `_left`, `_right`, and thrust, moment
// and shear force as `<layer>_section_1` …, at the nodes nearest to those places.
#pragma once

#include "coupler/tunnel/expand.hpp"

namespace adit::coupler {

// Adds the tunnels of a scene that have such linings to the scene of the expansion. Throws
// protocol::UserError below `tunnels[i]`.
void add_grid_tunnels(const scene::Scene& given, Expansion& expansion);

}  // namespace adit::coupler
