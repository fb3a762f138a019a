#include "fdm_server/supports/joint_use.hpp"

#include <limits>
#include <vector>

namespace adit::fdm {

// Means of what its halves see; at an end there is one.
JointUse joint_use(const Lining& lining, const Structures& structures, const LiningJoint& joint) {
  const JointLaw& law = *joint.segments;
  const auto beams = beams_at(lining, joint.node);
  const double share = 1 / static_cast<double>(beams.size());
  JointForces forces = JointForces::Zero();
  JointOpening opening = JointOpening::Zero();
  std::vector<double> bolts(law.bolts.size(), 0.0);
  for (const auto& [beam, end] : beams) {
    const SegmentJoint& half = *structures.segment_joint(beam);
    forces += share * half.forces();
    opening += share * half.opening();
    for (std::size_t k = 0; k < bolts.size(); ++k)
      bolts[k] += share * law.bolts[k].spacing *
                  law.bolts[k].force(opening_at(half.opening(), law.bolts[k].position), half.slack()[k]);
  }
  JointUse use{};
  use.thrust = lining.spacing * forces[0];
  use.moment = lining.spacing * forces[1];
  use.rotation = opening[1];
  use.outer_opening = opening_at(opening, law.edge);
  use.inner_opening = opening_at(opening, -law.edge);
  use.tightness = std::numeric_limits<double>::infinity();
  for (const double bolt : bolts) use.bolt_force = std::max(use.bolt_force, bolt);
  if (const auto& gasket = law.gasket) {
    use.gasket_opening = opening_at(opening, gasket->position);
    if (gasket->water_force > 0)
      use.tightness = -gasket->force.force(use.gasket_opening) / gasket->water_force;
  }
  return use;
}

bool any_segments(std::span<const Lining> linings) {
  return std::ranges::any_of(linings, [](const Lining& lining) {
    return std::ranges::any_of(lining.joints,
                               [](const LiningJoint& joint) { return joint.segments != nullptr; });
  });
}

}  // namespace adit::fdm
