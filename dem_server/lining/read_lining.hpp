// Sections, joints and ovals of a lining from the scene.
#pragma once

#include <span>

#include "dem_server/lining/lining.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// All sections and ovals, the joints that have a name, and those of the ring, named joint_0, joint_1 ….
// `bonds`: all pairs that are or were bonded, in the order of their numbers.
//
// protocol::UserError for a name that comes twice, a section without length, one that cuts no bond, a joint
// with fewer than two particles on a face, an oval with gaps.
Lining read_lining(const scene::Particles& scene, const Particles& particles, std::span<const Pair> bonds);

}  // namespace adit::dem
