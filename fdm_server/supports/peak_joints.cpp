#include "fdm_server/supports/peak_joints.hpp"

#include <cmath>

namespace adit::fdm {
namespace {

void take_joint(const PeakJoints::Instant& now, const std::function<double(const JointUse&)>& of,
                std::size_t joint, std::vector<PeakJoints::Instant>& largest) {
  if (joint == largest.size()) largest.push_back(now);
  if (of(now.use) > of(largest[joint].use)) largest[joint] = now;
}

}  // namespace

void PeakJoints::take(std::span<const Lining> linings, const Structures& structures, double time) {
  for_each_segment_joint(linings, [&](const Lining& lining, const LiningJoint& joint, std::size_t number) {
    const Instant now{joint_use(lining, structures, joint), time};
    take_joint(
        now, [](const JointUse& use) { return use.largest_opening(); }, number, extremes_.opening);
    take_joint(
        now, [](const JointUse& use) { return std::abs(use.rotation); }, number, extremes_.rotation);
    take_joint(
        now, [](const JointUse& use) { return use.bolt_force; }, number, extremes_.bolt_force);
    take_joint(
        now, [](const JointUse& use) { return -use.tightness; }, number, extremes_.tightness);
  });
}

void PeakJoints::exchange(std::span<const Lining> linings, state::Archive& archive) {
  std::size_t joints = 0;
  for_each_segment_joint(linings, [&](const Lining&, const LiningJoint&, std::size_t) { ++joints; });
  if (joints == 0) return;
  archive.all_or_none("lining_peak_joints",
                      {&extremes_.opening, &extremes_.rotation, &extremes_.bolt_force, &extremes_.tightness},
                      joints);
}

void for_each_segment_joint(std::span<const Lining> linings,
                            const std::function<void(const Lining&, const LiningJoint&, std::size_t)>& take) {
  std::size_t number = 0;
  for (const Lining& lining : linings)
    for (const LiningJoint& joint : lining.joints)
      if (joint.segments) take(lining, joint, number++);
}

}  // namespace adit::fdm
