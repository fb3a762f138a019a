#include "fdm_server/participant/joint_figures.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "fdm_server/participant/figures.hpp"

namespace adit::fdm {
namespace {

// The joints of one lining: their numbers, and whether any has bolts, a gasket against water.
struct JointsOfLining {
  struct Joint {
    std::size_t number;
    std::uint32_t point;
  };
  std::vector<Joint> joints{};
  bool bolts = false, water = false;
};

JointsOfLining joints_of(std::span<const Lining> linings, const Lining& one) {
  JointsOfLining found;
  for_each_segment_joint(linings, [&](const Lining& lining, const LiningJoint& joint, std::size_t number) {
    if (&lining != &one) return;
    const JointLaw& law = *joint.segments;
    found.joints.push_back({number, lining.path.points[joint.node]});
    found.bolts |= !law.bolts.empty();
    found.water |= law.gasket && law.gasket->water_force > 0;
  });
  return found;
}

}  // namespace

void add_figures(const Grid& grid, std::span<const Lining> linings, const PeakJoints& peaks, wire::Bye& bye) {
  if (peaks.empty()) return;
  Figures figures(grid, bye);
  for (const Lining& lining : linings) {
    const auto [joints, bolts, water] = joints_of(linings, lining);
    if (joints.empty()) continue;
    const std::string name = "lining_" + lining.name + "_";
    // Of the joint for which `of` was the largest.
    const auto add = [&](const std::vector<PeakJoints::Instant>& instants, const std::string& which,
                         const std::string& unit, const auto& of, const auto& value) {
      const auto at = std::ranges::max_element(
          joints, {}, [&](const JointsOfLining::Joint& joint) { return of(instants[joint.number].use); });
      const PeakJoints::Instant& instant = instants[at->number];
      figures.add(name + which + unit, value(instant.use));
      figures.add_when_and_where(name + which, instant.time, at->point);
      return instant.use;
    };
    const auto add_forces = [&](const JointUse& use, const std::string& which) {
      figures.add(name + "thrust_at_" + which + "_N", use.thrust);
      figures.add(name + "moment_at_" + which + "_Nm", use.moment);
    };
    const auto& [opening, rotation, bolt_force, tightness] = peaks.extremes();
    const auto largest_opening = [](const JointUse& use) { return use.largest_opening(); };
    add_forces(add(opening, "largest_joint_opening", "_m", largest_opening, largest_opening),
               "largest_joint_opening");
    add_forces(add(
                   rotation, "largest_joint_rotation", "_rad",
                   [](const JointUse& use) { return std::abs(use.rotation); },
                   [](const JointUse& use) { return use.rotation; }),
               "largest_joint_rotation");
    const auto force = [](const JointUse& use) { return use.bolt_force; };
    if (bolts) add(bolt_force, "largest_bolt_force", "_N", force, force);
    if (water)
      add(
          tightness, "least_tightness", "", [](const JointUse& use) { return -use.tightness; },
          [](const JointUse& use) { return use.tightness; });
  }
}

}  // namespace adit::fdm
