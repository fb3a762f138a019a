// The joints between the segments of a circular lining, the bolts, gaskets and keys across them, and the
// neighbouring rings that bridge them.
#pragma once

#include <string>
#include <vector>

#include "coupler/tunnel/contour.hpp"

namespace adit::coupler {

// From x [rad]: of a lining, of the second ring of one.
std::vector<double> joint_angles(const scene::TunnelLining& lining);
std::vector<double> joint_angles(const scene::TunnelLining& lining, const scene::SecondRing& ring);

// `path`: of the tunnel in the scene. Throws protocol::UserError for joints in a lining that is no circle,
// and for what crosses joints in a lining without any.
void require_joints_possible(const scene::LinedTunnel& tunnel, const std::string& path);
// Likewise where the ring beside it is stated twice or not at all, or the lining is tied to the ground.
void require_second_ring_possible(const scene::TunnelLining& lining, const std::string& path);
void add_joints(const scene::LinedTunnel& tunnel, const Contour& contour, const std::string& path,
                scene::Particles& particles);

}  // namespace adit::coupler
