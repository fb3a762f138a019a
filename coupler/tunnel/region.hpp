// The particles around a tunnel: ground, without the lining.
#pragma once

#include "coupler/tunnel/contour.hpp"

namespace adit::coupler {

// A hexagonal lattice that is its own mirror image in the vertical through the tunnel's middle, cut to the
// tunnel and the ground around it; the hole or its excavation; the loads of the continuum on all bodies.
scene::Particles region_around(const scene::LinedTunnel& tunnel, const Contour& contour,
                               const scene::Continuum& continuum);

}  // namespace adit::coupler
