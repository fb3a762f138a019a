// What a run records of a tunnel.
#pragma once

#include "coupler/tunnel/contour.hpp"

namespace adit::coupler {

// Displacements of the inner side: `<tunnel>_crown`, `_invert`, `_left`, `_right`.
void add_convergence(const scene::LinedTunnel& tunnel, const Contour& contour, scene::Particles& particles);

// Opening, offset and rotation of the joints that have names, forces of the springs that have names, changes
// of the diameters of the ovals, and thrust, moment and shear force in the sections, each under its own name.
void add_lining_histories(scene::Particles& particles);

}  // namespace adit::coupler
