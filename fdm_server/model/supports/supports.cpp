#include "fdm_server/model/supports/supports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <set>
#include <utility>

#include "fdm_server/grid/edges.hpp"
#include "fdm_server/model/grid/selection.hpp"
#include "fdm_server/model/grid/zone_stages.hpp"
#include "fdm_server/model/interfaces/law.hpp"
#include "fdm_server/model/interfaces/seams.hpp"
#include "fdm_server/model/supports/layers.hpp"
#include "fdm_server/model/supports/meetings.hpp"
#include "fdm_server/model/supports/members.hpp"
#include "fdm_server/model/supports/place_on_path.hpp"
#include "fdm_server/model/supports/reinforced_section.hpp"
#include "fdm_server/model/supports/rings.hpp"
#include "fdm_server/model/supports/segments.hpp"
#include "fdm_server/model/supports/stated_section.hpp"
#include "fdm_server/supports/curve.hpp"
#include "fdm_server/supports/trace.hpp"
#include "protocol/errors.hpp"
#include "protocol/geometry/read_path.hpp"
#include "protocol/ground/stages.hpp"

namespace adit::fdm {
namespace {

using protocol::require;

constexpr double kTurn = 2 * std::numbers::pi;

std::unique_ptr<Curve> read_circle(const scene::RoundPath& circle, const std::string& path) {
  geometry::require_arc(circle, path);
  return arc({circle.centre().x(), circle.centre().y()}, circle.radius(), circle.from(),
             circle.has_from() ? circle.to() : kTurn);
}

std::unique_ptr<Curve> read_line(const scene::LinePath& line, const std::string& path) {
  std::vector<geometry::Point> points;
  for (const auto& point : line.points()) {
    require(points.empty() || points.back().x != point.x() || points.back().y != point.y(), path + ".points",
            fmt::format("names ({}, {}) m twice in succession; leave one out", point.x(), point.y()));
    points.push_back({point.x(), point.y()});
  }
  geometry::require_simple(points, path);
  return polyline(std::move(points));
}

Path read_path(const scene::LiningPath& along, const Grid& grid, const Edges& edges,
               const std::string& path) {
  switch (along.path_case()) {
    case scene::LiningPath::kCircle:
      return trace(grid, edges, *read_circle(along.circle(), path + ".circle"), path + ".circle");
    case scene::LiningPath::kLine:
      return trace(grid, edges, *read_line(along.line(), path + ".line"), path + ".line");
    case scene::LiningPath::kWall:
      return chain(grid, select_edges(grid, along.wall(), path + ".wall"), path + ".wall");
    case scene::LiningPath::PATH_NOT_SET:
      break;
  }
  throw protocol::UserError(path, "names no path; give `circle`, `line` or `wall`");
}

// `share`: how much of each metre of the plane the lining has, of which `nodes` are the path.
std::vector<LiningJoint> read_joints(const scene::Lining& lining, const scene::LiningPath& along,
                                     const Path& nodes, const Grid& grid, const LiningSection* section,
                                     double share, const std::string& path) {
  std::vector<LiningJoint> joints;
  for (int i = 0; i < lining.joints_size(); ++i) {
    const auto& joint = lining.joints(i);
    const auto here = fmt::format("{}.joints[{}]", path, i);
    const auto segments = read_segments(lining, joint, section, share, here);
    require(
        !joint.has_yield_moment() || joint.rotational_stiffness() > 0, here + ".yield_moment",
        "is given to a hinge, which carries no moment; give its rotational_stiffness too, or leave it out");
    const auto node = nearest_node(place_of(joint, along, here), nodes, grid, here);
    for (std::size_t other = 0; other < joints.size(); ++other)
      require(joints[other].node != node, here,
              fmt::format("lies at the same node as joints[{}]; leave one out, or use shorter zones", other));
    joints.push_back({node, share * joint.rotational_stiffness(), share * joint.yield_moment(), segments});
  }
  require_segments_fit(lining, joints, nodes, path);
  return joints;
}

// Who lies on each side of a zone, by the points of the grid before cuts, which keep their numbers.
class Occupied {
 public:
  explicit Occupied(const Grid& grid) : grid_(grid) {}

  void take(const Path& along, const std::string& path) {
    for (std::size_t k = 0; k < along.sides(); ++k) {
      const auto [a, b] = along.side(k);
      const auto [owner, free] = owners_.try_emplace(std::minmax(a, b), path);
      require(
          free, path,
          fmt::format("lies on the side of a zone from ({:.6g}, {:.6g}) m to ({:.6g}, {:.6g}) m, where {} is "
                      "already; let only one of them run there",
                      grid_.x[a], grid_.y[a], grid_.x[b], grid_.y[b], owner->second));
    }
  }
  void take(Path along, const Grid& cut, const std::string& path) {
    for (auto& point : along.points) point = cut.place(point);
    take(along, path);
  }

 private:
  const Grid& grid_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> owners_;
};

void add_bolt(const scene::Bolt& bolt, const Grid& grid, const Edges& edges, const std::string& path,
              Occupied& occupied, Supports& supports) {
  require(bolt.from().x() != bolt.to().x() || bolt.from().y() != bolt.to().y(), path + ".to",
          "is the same place as `from`; give the bolt a length");
  const auto line = polyline({{bolt.from().x(), bolt.from().y()}, {bolt.to().x(), bolt.to().y()}});
  const Path along = trace(grid, edges, *line, path);
  occupied.take(along, grid, path);
  auto& structures = supports.structures;
  const double area = bolt.area() / bolt.spacing();
  const BarSection section{bolt.young_modulus() * area, bolt.yield_force() / bolt.spacing(),
                           bolt.density() * area};
  const auto first = static_cast<std::uint32_t>(structures.bars().size());
  for (std::size_t k = 0; k + 1 < along.points.size(); ++k) {
    const auto a = along.points[k], b = along.points[k + 1];
    structures.add_bar(Bar({a, b}, chord(grid.x[a], grid.y[a], grid.x[b], grid.y[b]), section));
  }
  supports.bolts.push_back(
      {along, first, static_cast<std::uint32_t>(structures.bars().size()) - first, bolt.spacing()});
}

// The sides that two groups of zones share, with the second on the right.
Path shared_sides(const scene::GroupPair& pair, const Grid& grid, const std::string& path) {
  require(pair.left() != pair.right(), path + ".right",
          "is `" + pair.right() + "`, as `left` is; name two groups that touch");
  const auto zones = [&](const std::string& name, const std::string& key) {
    scene::Area area;
    area.set_group(name);
    std::vector<bool> of_group(grid.zones.size(), false);
    for (const auto zone : select_zones(grid, area, path + key)) of_group[zone] = true;
    return of_group;
  };
  const auto left = zones(pair.left(), ".left"), right = zones(pair.right(), ".right");
  std::map<std::pair<std::int32_t, std::int32_t>, bool> sides_of_left;
  const auto for_each_side = [&](const std::vector<bool>& of_group, const auto& take) {
    for (std::uint32_t z = 0; z < grid.zones.size(); ++z)
      for (std::size_t c = 0; of_group[z] && c < 4; ++c)
        take(grid.zones[z][c], grid.zones[z][(c + 1) % 4], z);
  };
  for_each_side(left, [&](auto from, auto to, auto) { sides_of_left[{from, to}] = true; });
  std::vector<Edge> shared;
  for_each_side(right, [&](auto from, auto to, auto zone) {
    if (sides_of_left.contains({to, from})) shared.push_back({from, to, zone});
  });
  require(!shared.empty(), path,
          fmt::format("names the groups `{}` and `{}`, which share no side of a zone; name two that touch",
                      pair.left(), pair.right()));
  return chain(grid, shared, path);
}

Path read_path(const scene::GridInterface& interface, const Grid& grid, const Edges& edges,
               const std::string& path) {
  require(interface.has_along() != interface.has_between(), path,
          "needs one path; give either `along` or `between`");
  return interface.has_between() ? shared_sides(interface.between(), grid, path + ".between")
                                 : read_path(interface.along(), grid, edges, path + ".along");
}

// A free field goes on as the side does, whose points belong to one column.
std::vector<bool> points_at_free_field(const scene::FreeField& free_field, const Grid& grid) {
  const auto box = bounds(grid);
  std::vector<bool> at(grid.x.size(), false);
  for (std::size_t i = 0; i < at.size(); ++i)
    at[i] = (free_field.left() && grid.x[i] <= box.x_min + tolerance(grid)) ||
            (free_field.right() && grid.x[i] >= box.x_max - tolerance(grid));
  return at;
}

// All interfaces, then linings that have one.
struct SeamPaths {
  std::vector<Seams::Seam> seams;
  std::map<int, std::size_t> of_lining;  // their numbers
};

// The lining whose stated path a lining follows: without one of its own, that on or beside which it lies.
int leader(int lining, const scene::Continuum& scene, const std::vector<int>& below, const Rings& rings) {
  if (scene.linings(lining).has_along()) return lining;
  const auto number = static_cast<std::size_t>(lining);
  const int next = std::max(below[number], rings.beside()[number]);
  require(next >= 0, fmt::format("continuum.linings[{}]", lining),
          "has no path; give `along`, or the lining that it lies `on`");
  return leader(next, scene, below, rings);
}

Path path_of(int leader, const scene::Continuum& scene, const Grid& grid, const Edges& edges) {
  return read_path(scene.linings(leader).along(), grid, edges,
                   fmt::format("continuum.linings[{}].along", leader));
}

SeamPaths read_seams(const scene::Continuum& scene, const std::vector<int>& leaders, const Rings& rings,
                     const Grid& grid, const Edges& edges, Occupied& occupied) {
  SeamPaths found;
  auto& seams = found.seams;
  for (int i = 0; i < scene.interfaces_size(); ++i) {
    const auto path = fmt::format("continuum.interfaces[{}]", i);
    seams.push_back({read_path(scene.interfaces(i), grid, edges, path), true});
    occupied.take(seams.back().path, path);
  }
  for (int i = 0; i < scene.linings_size(); ++i) {
    if (!scene.linings(i).has_interface()) continue;
    require(!scene.large_strain(), fmt::format("continuum.linings[{}].interface", i),
            "keeps its partners, which `continuum.large_strain` moves away; leave one of the two out");
    const bool on_ground = !scene.linings(i).has_on() && !rings.is_second(i);
    found.of_lining[i] = seams.size();
    seams.push_back({path_of(leaders[static_cast<std::size_t>(i)], scene, grid, edges),
                     on_ground && scene.linings(i).stage() == 0});
    if (on_ground) occupied.take(seams.back().path, fmt::format("continuum.linings[{}]", i));
  }
  require(scene.interfaces().empty() || scene.excavations().empty() || !scene.large_strain(),
          "continuum.excavations",
          "take zones away along which interfaces slide in large strain, which is not computed; leave "
          "large_strain, the interfaces or the excavations out");
  return found;
}

// Of a lining: a copy of each point of its path; linings that meet in a point share it.
Path own_points(const Path& path, std::map<std::uint32_t, std::uint32_t>& own, Grid& grid) {
  Path copies = path;
  for (auto& point : copies.points) {
    const auto [copy, added] = own.try_emplace(point, static_cast<std::uint32_t>(grid.x.size()));
    if (added) {
      grid.x.push_back(grid.x[point]);
      grid.y.push_back(grid.y[point]);
      grid.double_of.push_back(grid.place(point));
    }
    point = copy->second;
  }
  return copies;
}

// In stage 0 the grid is cut along the lining, which may stand in the middle of it. Later the zones on one
// side are gone: until then they are joined to the others.
void require_ground_on_one_side(const Path& along, const Seams& seams, const std::vector<bool>& there,
                                const std::string& path) {
  for (std::size_t k = 0; k < along.sides(); ++k) {
    const auto beside = seams.beside(along, k);
    const auto count =
        std::ranges::count_if(beside, [&](auto zone) { return zone != kNoZone && there[zone]; });
    require(count == 1, path + ".interface",
            count == 0
                ? "has no ground to bear on along a part of the lining; let a side of it be ground"
                : "lies between zones on both sides of the lining in the stage in which it is installed; "
                  "excavate one side by then, or install it in stage 0");
  }
}

}  // namespace

Supports resolve_supports(const scene::Scene& scene, const Ground& ground, std::span<const double> weights,
                          Grid& grid) {
  const auto& linings = scene.continuum().linings();
  const auto& bolts = scene.continuum().bolts();
  const auto& interfaces = scene.continuum().interfaces();
  Supports supports;
  if (linings.empty() && bolts.empty() && interfaces.empty() && scene.continuum().members().empty())
    return supports;
  require_same_values(scene.continuum());
  Occupied occupied(grid);
  Edges edges = number_edges(grid);
  const std::vector<int> below = read_layers(linings);
  const Rings rings(linings);
  std::vector<int> leaders;
  for (int i = 0; i < linings.size(); ++i) leaders.push_back(leader(i, scene.continuum(), below, rings));
  const SeamPaths seam_paths = read_seams(scene.continuum(), leaders, rings, grid, edges, occupied);
  const Seams seams(seam_paths.seams, points_at_free_field(scene.continuum().free_field(), grid), ground,
                    weights, grid);
  if (!grid.double_of.empty()) edges = number_edges(grid);

  std::set<std::string> names;
  for (int i = 0; i < interfaces.size(); ++i) {
    const auto path = fmt::format("continuum.interfaces[{}]", i);
    require(names.insert(interfaces[i].name()).second, path + ".name",
            "`" + interfaces[i].name() + "` is taken by another interface; choose another one");
    auto& joined = supports.interfaces.emplace_back(
        seams.join(seam_paths.seams[static_cast<std::size_t>(i)].path,
                   read_law(interfaces[i].law(), path + ".law"), ground.large_strain, supports.contacts));
    joined.name = interfaces[i].name();
    require(joined.count > 0, path, "has zones on one side only; let it run inside the grid");
  }

  for (int i = 0; i < linings.size(); ++i)
    require(names.insert(linings[i].name()).second, fmt::format("continuum.linings[{}].name", i),
            "`" + linings[i].name() + "` is taken by another lining or an interface; choose another one");
  // Points of linings with interfaces to the ground, of rings beside them, of layers.
  std::map<std::uint32_t, std::uint32_t> own, of_second_rings, of_layers;
  std::vector<LiningPlan> plans(static_cast<std::size_t>(linings.size()));
  const std::vector<std::size_t> order = from_the_ground(below);
  for (const std::size_t number : order) {
    const auto i = static_cast<int>(number);
    const auto& lining = linings[i];
    const auto path = fmt::format("continuum.linings[{}]", i);
    const double share = rings.share(i);
    const auto section = read_section(lining, share, 1, path);
    Section elastic =
        section ? elastic_section(*section, lining)
                : read_elastic_section(lining, share, share, scene.plane() == scene::PLANE_STRAIN, path);
    const auto on_seam = seam_paths.of_lining.find(i);
    Path along = on_seam != seam_paths.of_lining.end()
                     ? seam_paths.seams[on_seam->second].path
                     : path_of(leaders[number], scene.continuum(), grid, edges);
    if (below[number] >= 0) {
      const LiningPlan& first = plans[static_cast<std::size_t>(below[number])];
      along = on_points_of(first, along, grid, path + ".along");
      if (!lining.has_interface())
        elastic.offset = first.elastic.offset - between_axes(linings[below[number]], lining, path);
    } else if (!lining.has_interface()) {
      occupied.take(along, grid, path);
    }
    if (lining.has_interface())
      along = own_points(along,
                         below[number] >= 0   ? of_layers
                         : rings.is_second(i) ? of_second_rings
                                              : own,
                         grid);
    protocol::require_statics(scene, lining.stage(), path);
    plans[number] = {
        lining.name(),
        along,
        elastic,
        read_joints(lining, linings[leaders[number]].along(), along, grid, section.get(), share, path),
        lining.first_end_fixed(),
        lining.last_end_fixed(),
        section,
        below[number] >= 0 && !lining.has_interface() ? lining.on() : "",
        1 / share};
  }
  std::vector<LiningPlan> from_inside;  // members stand on the last layer
  for (auto number = order.rbegin(); number != order.rend(); ++number) from_inside.push_back(plans[*number]);
  const std::vector<LiningPlan> members = plan_members(scene, from_inside, names, grid);
  rings.require_free_of_members(plans, members);
  require_clear_joints(plans, members, grid);
  for (int i = 0; i < linings.size(); ++i) {
    supports.structures.set_stage(linings[i].stage());
    supports.linings.push_back(add_lining(plans[static_cast<std::size_t>(i)], grid, supports.structures));
  }
  rings.add_dowels(linings, plans, grid, supports);
  for (int i = 0; i < scene.continuum().members_size(); ++i) {
    supports.structures.set_stage(scene.continuum().members(i).stage());
    supports.members.push_back(add_lining(members[static_cast<std::size_t>(i)], grid, supports.structures));
  }
  const auto stages =
      seam_paths.of_lining.empty() ? ZoneStages() : ZoneStages(scene, grid, ground.stated_of_zones());
  for (const auto& [i, number] : seam_paths.of_lining) {
    const auto& lining = linings[i];
    const Path& along = seam_paths.seams[number].path;
    const auto path = fmt::format("continuum.linings[{}]", i);
    const ContactLaw law = read_law(lining.interface(), path + ".interface");
    const auto& own_path = plans[static_cast<std::size_t>(i)].path.points;
    const int on = below[static_cast<std::size_t>(i)];
    if (on < 0 && lining.stage() > 0)
      require_ground_on_one_side(along, seams, stages.there(lining.stage()), path);
    Interface joined =
        on < 0
            ? seams.join(along, own_path, law, rings.share(i), lining.stage(), supports.contacts)
            : seams.join(along, on_points_of(plans[static_cast<std::size_t>(on)], along, grid, path).points,
                         own_path, law, lining.stage(), supports.contacts);
    joined.name = lining.name();
    supports.interfaces.push_back(std::move(joined));
  }
  supports.contacts.install(0, std::vector<bool>(grid.zones.size(), false));

  for (int i = 0; i < bolts.size(); ++i) {
    const auto path = fmt::format("continuum.bolts[{}]", i);
    protocol::require_statics(scene, bolts[i].stage(), path);
    supports.structures.set_stage(bolts[i].stage());
    add_bolt(bolts[i], grid, edges, path, occupied, supports);
  }
  return supports;
}

}  // namespace adit::fdm
