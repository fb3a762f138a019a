// The joints between the segments of a circular lining, the bolts, gaskets and keys across them, and the
// neighbouring rings that bridge them.
#pragma once

#include <string>

#include "coupler/tunnel/contour.hpp"

namespace adit::coupler {

// `path`: of the tunnel in the scene. Throws protocol::UserError for joints in a lining that is no circle,
// and for what crosses joints in a lining without any.
void add_joints(const scene::LinedTunnel& tunnel, const Contour& contour, const std::string& path,
                scene::Particles& particles);

}  // namespace adit::coupler
