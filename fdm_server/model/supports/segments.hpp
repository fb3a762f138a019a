// Joints of segments as the scene states them.
// Errors: UserError with the scene's path where faces, bolts or a gasket do not fit into the lining, a spring
// is given too, or nothing balances the pretension of bolts.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "fdm_server/structures/joint_law.hpp"
#include "fdm_server/supports/lining.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// None for a joint without `contact`. `section`: the lining's, if it is of reinforced concrete. `share`: how
// much of each metre of the plane the lining has.
std::shared_ptr<const JointLaw> read_segments(const scene::Lining& lining, const scene::LiningJoint& joint,
                                              const LiningSection* section, double share,
                                              const std::string& path);

// `path`: of the lining. Segments are at least two beams long, and end inside the lining or in a plane of
// symmetry.
void require_segments_fit(const scene::Lining& lining, std::span<const LiningJoint> joints, const Path& along,
                          const std::string& path);

}  // namespace adit::fdm
