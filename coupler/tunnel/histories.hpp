// What a run records of a tunnel.
#pragma once

#include "coupler/tunnel/contour.hpp"

namespace adit::coupler {

// Displacements of the inner side: `<tunnel>_crown`, `_invert`, `_left`, `_right`.
void add_convergence(const scene::LinedTunnel& tunnel, const Contour& contour, scene::Particles& particles);

}  // namespace adit::coupler
