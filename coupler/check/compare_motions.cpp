#include "coupler/check/compare_motions.hpp"

#include "protocol/motion/excitation/ground_motion.hpp"

namespace adit::coupler {

void compare_motions(Model& model) {
  for (const Participant& participant : model.participants) {
    if (participant.member.role != Role::kContinuum) continue;
    const scene::GroundMotion& stated = continuum_of(model.scene, participant.member).base().acceleration();
    if (!stated.has_peak()) continue;
    const std::string path = participant.member.path + ".base.acceleration";
    add_where_it_differs(model.stated,
                         {.key = path + ".peak",
                          .stated = stated.peak(),
                          .acted = motion::ground_motion(stated, path, model.scene.time().duration()).peak,
                          .unit = "m/s^2",
                          .why = "the run takes a part of the motion"});
  }
}

}  // namespace adit::coupler
