// The particles around a tunnel: ground, without the lining.
#pragma once

#include <string>
#include <vector>

#include "coupler/tunnel/contour.hpp"

namespace adit::coupler {

// A hexagonal lattice that is its own mirror image in the vertical through the tunnel's middle, cut to the
// tunnel and the ground around it; the hole or its excavation; the loads of the continuum on all bodies.
// Where the tunnel states no material of its ground, it is that of the zones at each place: groups
// `<tunnel>_ground_1` … for the areas of `continuum.materials` that reach into it, but for groups of a mesh,
// whose places only the grid knows. Throws protocol::UserError for areas that enclose nothing.
struct TunnelGround {
  scene::Particles particles;
  std::vector<int> zones;            // of each of its first groups: the number in `continuum.materials`
  std::vector<std::string> elastic;  // paths of zones' materials of which it has the elasticity alone
};
TunnelGround ground_around(const scene::LinedTunnel& tunnel, const Contour& contour,
                           const scene::Continuum& continuum);

}  // namespace adit::coupler
