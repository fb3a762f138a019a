#include "fdm_server/model/supports/members.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "fdm_server/model/supports/stated_section.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"

namespace adit::fdm {
namespace {

using geometry::Point;
using protocol::require;

// The points that a member may end at. Where several lie at one place, that of the first lining, then of a
// member.
class Ends {
 public:
  Ends(std::span<const LiningPlan> linings, Grid& grid) : grid_(grid) {
    for (const LiningPlan& lining : linings) add(lining.path.points);
    for (const auto& zone : grid.zones)
      for (const auto point : zone) of_grid_.push_back(static_cast<std::uint32_t>(point));
  }
  void add(std::span<const std::uint32_t> points) {
    known_.insert(known_.end(), points.begin(), points.end());
  }

  // Within `reach` of the place; a new point, where nothing is yet: another member must end there.
  std::uint32_t find(const Point& place, double reach, const std::string& path) {
    for (const auto* points : {&known_, &of_grid_})
      if (const auto [point, distance] = nearest(*points, place); distance <= reach) {
        lone_.erase(point);
        return point;
      }
    const auto point = new_point(place);
    lone_[point] = path;
    return point;
  }
  std::uint32_t new_point(const Point& place) {
    const auto point = static_cast<std::uint32_t>(grid_.x.size());
    grid_.x.push_back(place.x);
    grid_.y.push_back(place.y);
    grid_.double_of.push_back(point);  // it shares no place
    return point;
  }

  void require_met() const {
    if (lone_.empty()) return;
    const auto& [point, path] = *lone_.begin();
    const Point place{grid_.x[point], grid_.y[point]};
    const auto next = nearest(of_grid_, place).point;
    throw protocol::UserError(
        path,
        fmt::format("is ({:.6g}, {:.6g}) m, where the member meets nothing; put it at a node of a lining, "
                    "an end of another member, or a grid point, such as ({:.6g}, {:.6g}) m",
                    place.x, place.y, grid_.x[next], grid_.y[next]));
  }

 private:
  struct Found {
    std::uint32_t point;
    double distance;
  };
  Found nearest(std::span<const std::uint32_t> points, const Point& place) const {
    Found found{0, HUGE_VAL};
    for (const auto point : points)
      if (const double d = std::hypot(grid_.x[point] - place.x, grid_.y[point] - place.y); d < found.distance)
        found = {point, d};
    return found;
  }

  Grid& grid_;
  std::vector<std::uint32_t> known_, of_grid_;
  std::map<std::uint32_t, std::string> lone_;  // new ends, until another member meets them
};

Path read_path(const scene::Member& member, Ends& ends, const Grid& grid, const std::string& path) {
  const Point from{member.from().x(), member.from().y()}, to{member.to().x(), member.to().y()};
  require(from.x != to.x || from.y != to.y, path + ".to",
          "is the same place as `from`; give the member a length");
  const double reach = 0.01 * std::hypot(to.x - from.x, to.y - from.y);
  const auto first = ends.find(from, reach, path + ".from"), last = ends.find(to, reach, path + ".to");
  Path along{{first}, false};
  const double x = grid.x[first], y = grid.y[first], dx = grid.x[last] - x, dy = grid.y[last] - y;
  for (std::uint32_t k = 1; k < member.elements(); ++k) {
    const double share = static_cast<double>(k) / member.elements();
    along.points.push_back(ends.new_point({x + share * dx, y + share * dy}));
  }
  along.points.push_back(last);
  return along;
}

std::optional<MemberStrength> read_failure(const scene::Member& member, const LiningSection* section,
                                           const std::string& path) {
  if (!member.has_failure()) return std::nullopt;
  require(section != nullptr, path + ".failure",
          "needs the strength of a `section` of reinforced concrete; give one, or leave the failure out");
  require(!section->elastic, path + ".failure",
          "is given, but the `section` is `elastic`; leave one of them out");
  return MemberStrength{section->strength.shear, member.failure().residual(), member.failure().sliding(),
                        section->fibres->shape().thickness - 2 * section->cover};
}

LiningPlan plan_member(const scene::Member& member, bool plane_strain, Ends& ends, const Grid& grid,
                       const std::string& path) {
  const double spacing = member.spacing(), width = member.has_width() ? member.width() : spacing;
  require(width <= spacing, path + ".width",
          fmt::format("is {:.6g} m, more than the spacing of {:.6g} m; give at most that", width, spacing));
  const double core = width < spacing ? std::max(0.0, 1 - 2 * member.section().cover() / width) : 1;
  const auto section = read_section(member, width / spacing, core, path);
  const Section elastic = section ? elastic_section(*section, member)
                                  : read_elastic_section(member, width / spacing, 1 / spacing,
                                                         plane_strain && width == spacing, path);
  LiningPlan plan{member.name(), read_path(member, ends, grid, path), elastic, {}, false, false, section};
  if (member.first_end_hinged()) plan.joints.push_back({0, 0, 0});
  if (member.last_end_hinged()) plan.joints.push_back({member.elements(), 0, 0});
  plan.spacing = spacing;
  plan.follows_chord = true;
  plan.strength = read_failure(member, section.get(), path);
  return plan;
}

}  // namespace

std::vector<LiningPlan> plan_members(const scene::Scene& scene, std::span<const LiningPlan> linings,
                                     std::set<std::string>& names, Grid& grid) {
  std::vector<LiningPlan> plans;
  const auto& members = scene.continuum().members();
  if (members.empty()) return plans;
  Ends ends(linings, grid);
  for (int i = 0; i < members.size(); ++i) {
    const auto path = fmt::format("continuum.members[{}]", i);
    require(names.insert(members[i].name()).second, path + ".name",
            "`" + members[i].name() + "` is taken by another part of the model; choose another one");
    protocol::require_statics(scene, members[i].stage(), path);
    plans.push_back(plan_member(members[i], scene.plane() == scene::PLANE_STRAIN, ends, grid, path));
    ends.add(plans.back().path.points);
  }
  ends.require_met();
  return plans;
}

}  // namespace adit::fdm
