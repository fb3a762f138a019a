// The lining of a tunnel in its particles.
#pragma once

#include <string>

#include "coupler/tunnel/contour.hpp"

namespace adit::coupler {

// Adds the group of the lining, its bonds to the ground, its joints, its sections, its diameters, and the
// histories of all of them. `path`: of the tunnel in the scene. Throws protocol::UserError for joints that it
// cannot have (joints.hpp).
void add_lining(const scene::LinedTunnel& tunnel, const Contour& contour, const std::string& path,
                scene::Particles& particles);

}  // namespace adit::coupler
