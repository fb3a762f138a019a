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

using Passages = std::map<std::uint32_t, std::vector<Passage>>;  // by points

void add_passages(std::span<const LiningPlan> plans, Passages& found) {
  for (const LiningPlan& plan : plans) {
    const auto& [points, closed] = plan.path;
    for (std::size_t node = 0; node < points.size(); ++node) {
      Passage passage{&plan, !closed && (node == 0 || node + 1 == points.size()), {}};
      const auto joint = std::ranges::find(plan.joints, node, &LiningJoint::node);
      if (joint != plan.joints.end()) passage.joint = *joint;
      found[points[node]].push_back(passage);
    }
  }
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

void require_clear_joints(std::span<const LiningPlan> plans, std::span<const LiningPlan> members,
                          const Grid& grid) {
  Passages all;
  add_passages(plans, all);
  add_passages(members, all);
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
    std::set<std::size_t> chains;
  };
  std::vector<const Lining*> chains;
  for (const auto* list : {&supports.linings, &supports.members})
    for (const Lining& chain : *list) chains.push_back(&chain);
  const auto is_member = [&](std::size_t k) { return k >= supports.linings.size(); };
  std::map<std::uint32_t, Meeting> by_rotation;
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < chains.size(); ++k) {
    if (!chains[k]->bonded_to.empty()) {
      notes.push_back(fmt::format("the lining `{}` is bonded to `{}` and bends with it as one section",
                                  chains[k]->name, chains[k]->bonded_to));
      continue;
    }
    for (const Beam& beam : supports.structures.beams().subspan(chains[k]->first_beam, chains[k]->beams))
      for (std::size_t end = 0; end < 2; ++end) {
        Meeting& meeting = by_rotation[beam.rotations()[end]];
        meeting.point = beam.points()[end];
        meeting.chains.insert(k);
      }
  }
  std::map<std::set<std::size_t>, std::vector<std::string>> places;
  for (const auto& [rotation, meeting] : by_rotation) {
    const std::size_t last = *meeting.chains.rbegin();
    const auto& ends = chains[last]->path.points;
    const bool free_end = meeting.chains.size() == 1 && is_member(last) &&
                          (meeting.point == ends.front() || meeting.point == ends.back());
    if (meeting.chains.size() > 1 || free_end) places[meeting.chains].push_back(place(grid, meeting.point));
  }
  for (const auto& [met, where] : places) {
    std::vector<std::string> names;
    for (const auto k : met) names.push_back((is_member(k) ? "member `" : "`") + chains[k]->name + "`");
    if (met.size() == 1)
      notes.push_back(fmt::format("{} turns freely at {} m", names.front(), listed(where)));
    else
      notes.push_back(fmt::format("{}{} are joined rigidly at {} m",
                                  is_member(*met.rbegin()) ? "" : "the linings ", listed(names),
                                  listed(where)));
  }
  return notes;
}

}  // namespace adit::fdm
