// The lining of a tunnel in its particles.
#pragma once

#include <array>
#include <string>
#include <utility>

#include "coupler/tunnel/contour.hpp"

namespace adit::coupler {

// Adds the group of the lining, its bonds to the ground, its joints, its sections, its diameters, and the
// histories of all of them. `path`: of the tunnel in the scene. Throws protocol::UserError for joints that it
// cannot have (joints.hpp).
void add_lining(const scene::LinedTunnel& tunnel, const Contour& contour, const std::string& path,
                scene::Particles& particles);

// Crown, invert, left and right of an outline.
std::array<std::pair<const char*, geometry::Point>, 4> convergence_places(const Contour& contour,
                                                                          double offset);

// Displacements of the inner side: `<tunnel>_crown`, `_invert`, `_left`, `_right`.
void add_convergence(const scene::LinedTunnel& tunnel, const Contour& contour, scene::Particles& particles);

// Opening, offset and rotation of the joints that have names, forces of the springs that have names, changes
// of the diameters of the ovals, and thrust, moment and shear force in the sections, each under its own name.
void add_lining_histories(scene::Particles& particles);

}  // namespace adit::coupler
