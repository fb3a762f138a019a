#include "fdm_server/model/supports/meetings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

// A lining that passes or ends at a node.
struct Passage {
  const LiningPlan* plan;
  bool ends;                         // there, with one beam instead of two
  std::optional<LiningJoint> joint;  // there

  bool hinged() const { return ends && joint && joint->stiffness == 0 && !joint->segments; }
};

std::map<std::uint32_t, std::vector<Passage>> passages(std::span<const LiningPlan> plans) {
  std::map<std::uint32_t, std::vector<Passage>> found;
  for (const LiningPlan& plan : plans) {
    const auto& [points, closed] = plan.path;
    for (std::size_t node = 0; node < points.size(); ++node) {
      Passage passage{&plan, !closed && (node == 0 || node + 1 == points.size()), {}};
      const auto joint = std::ranges::find(plan.joints, node, &LiningJoint::node);
      if (joint != plan.joints.end()) passage.joint = *joint;
      found[points[node]].push_back(passage);
    }
  }
  return found;
}

std::string place(const Grid& grid, std::uint32_t point) {
  return fmt::format("({:.6g}, {:.6g})", grid.x[point], grid.y[point]);
}

// "a, b and c"
std::string listed(std::vector<std::string> words) {
  const std::string last = words.back();
  words.pop_back();
  return words.empty() ? last : fmt::format("{} and {}", fmt::join(words, ", "), last);
}

}  // namespace

void require_clear_joints(std::span<const LiningPlan> plans, const Grid& grid) {
  const auto all = passages(plans);
  for (std::size_t i = 0; i < plans.size(); ++i)
    for (std::size_t j = 0; j < plans[i].joints.size(); ++j) {
      const auto& [points, closed] = plans[i].path;
      const auto node = plans[i].joints[j].node;
      const auto path = fmt::format("continuum.linings[{}].joints[{}]", i, j);
      const auto& here = all.at(points[node]);
      if (!closed && (node == 0 || node + 1 == points.size())) {
        if (plans[i].joints[j].segments) {
          if (here.size() > 1)
            throw protocol::UserError(
                path,
                "is of segments (`contact`), but lies at an end of the lining, where others meet it; put it "
                "inside the lining, or join them by a spring or hinge");
        } else if (here.size() == 1)
          throw protocol::UserError(
              path,
              "lies at an end of the lining, where no other lining is; leave it out, or put it where "
              "linings meet");
        continue;
      }
      for (const Passage& other : here)
        if (other.plan != &plans[i] && !other.hinged())
          throw protocol::UserError(
              path, fmt::format("lies between two beams of the lining at {} m, where `{}` may be joined to "
                                "either; let two linings end here instead, one of them with the joint, or "
                                "hinge `{}` by a joint at its end",
                                place(grid, points[node]), other.plan->name, other.plan->name));
    }
}

std::vector<std::string> notes_on_meetings(const Supports& supports, const Grid& grid) {
  struct Meeting {
    std::uint32_t point;
    std::set<std::size_t> linings;
  };
  std::map<std::uint32_t, Meeting> by_rotation;
  for (std::size_t k = 0; k < supports.linings.size(); ++k) {
    const Lining& lining = supports.linings[k];
    for (const Beam& beam : supports.structures.beams().subspan(lining.first_beam, lining.beams))
      for (std::size_t end = 0; end < 2; ++end) {
        Meeting& meeting = by_rotation[beam.rotations()[end]];
        meeting.point = beam.points()[end];
        meeting.linings.insert(k);
      }
  }
  std::map<std::set<std::size_t>, std::vector<std::string>> places;
  for (const auto& [rotation, meeting] : by_rotation)
    if (meeting.linings.size() > 1) places[meeting.linings].push_back(place(grid, meeting.point));
  std::vector<std::string> notes;
  for (const auto& [linings, where] : places) {
    std::vector<std::string> names;
    for (const auto k : linings) names.push_back("`" + supports.linings[k].name + "`");
    notes.push_back(fmt::format("the linings {} are joined rigidly at {} m", listed(names), listed(where)));
  }
  return notes;
}

}  // namespace adit::fdm
