#include "fdm_server/model/supports/supports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "fdm_server/grid/edges.hpp"
#include "fdm_server/model/grid/selection.hpp"
#include "fdm_server/model/supports/meetings.hpp"
#include "fdm_server/model/supports/reinforced_section.hpp"
#include "fdm_server/supports/curve.hpp"
#include "fdm_server/supports/trace.hpp"
#include "protocol/errors.hpp"
#include "protocol/geometry/polygon.hpp"

namespace adit::fdm {
namespace {

using protocol::require;

constexpr double kTurn = 2 * std::numbers::pi;

void require_statics(std::uint32_t stage, const scene::Scene& scene, const std::string& path) {
  require(
      stage == 0 || scene.has_statics(), path + ".stage",
      fmt::format("is {}, but stages begin when the ground is at rest, and the scene has no statics; give "
                  "`statics: {{unbalanced_ratio: 1e-5}}`, or stage 0",
                  stage));
}

std::unique_ptr<Curve> read_circle(const scene::RoundPath& circle, const std::string& path) {
  require(circle.has_from() == circle.has_to(), path,
          "names one end of an arc; give `from` and `to`, or neither for a whole circle");
  require(!circle.has_from() || (circle.to() > circle.from() && circle.to() - circle.from() <= kTurn),
          path + ".to",
          fmt::format("is {} rad, but must be larger than `from` = {} rad, by at most a full turn",
                      circle.to(), circle.from()));
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
  require(geometry::is_simple_line(points), path + ".points",
          "cross, touch or run back over one another; give a line that passes every place once");
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

Section read_elastic_section(const scene::Lining& lining, bool plane_strain, const std::string& path) {
  const bool both = lining.has_area() && lining.has_inertia(),
             any = lining.has_area() || lining.has_inertia();
  require(
      lining.has_thickness() ? !any : both, path,
      "needs a section: give either `thickness`, or both `area` and `inertia`, or `section` of reinforced "
      "concrete");
  require(lining.has_young_modulus(), path + ".young_modulus",
          "is missing; give it, such as `30 GPa`, or a `section` of reinforced concrete");
  const double area = both ? lining.area() : lining.thickness();
  const double inertia = both ? lining.inertia() : std::pow(lining.thickness(), 3) / 12;
  return make_section(
      lining_material(plane_strain, lining.young_modulus(), lining.poisson_ratio(), lining.density()), area,
      inertia, lining.shear_flexible());
}

std::shared_ptr<const LiningSection> read_section(const scene::Lining& lining, const std::string& path) {
  if (!lining.has_section()) return nullptr;
  const auto lone = [&](bool given, const char* key) {
    require(!given, path + "." + key, "is given beside `section`, which states it; leave one out");
  };
  lone(lining.has_thickness(), "thickness");
  lone(lining.has_area(), "area");
  lone(lining.has_inertia(), "inertia");
  lone(lining.has_young_modulus(), "young_modulus");
  return read_reinforced_section(lining.section(), path + ".section");
}

geometry::Point place_of(const scene::LiningJoint& joint, const scene::LiningPath& along,
                         const std::string& path) {
  require(joint.has_at() != joint.has_angle(), path, "needs one place: give either `at` or `angle`");
  if (joint.has_at()) return {joint.at().x(), joint.at().y()};
  require(along.has_circle(), path + ".angle",
          "counts around a circle, but the lining follows none; give `at` instead");
  const auto& circle = along.circle();
  return {circle.centre().x() + circle.radius() * std::cos(joint.angle()),
          circle.centre().y() + circle.radius() * std::sin(joint.angle())};
}

std::vector<LiningJoint> read_joints(const scene::Lining& lining, const Path& along, const Grid& grid,
                                     const std::string& path) {
  std::vector<LiningJoint> joints;
  for (int i = 0; i < lining.joints_size(); ++i) {
    const auto& joint = lining.joints(i);
    const auto here = fmt::format("{}.joints[{}]", path, i);
    require(
        !joint.has_yield_moment() || joint.rotational_stiffness() > 0, here + ".yield_moment",
        "is given to a hinge, which carries no moment; give its rotational_stiffness too, or leave it out");
    const auto node = nearest_node(place_of(joint, lining.along(), here), along, grid, here);
    for (std::size_t other = 0; other < joints.size(); ++other)
      require(joints[other].node != node, here,
              fmt::format("lies at the same node as joints[{}]; leave one out, or use shorter zones", other));
    joints.push_back({node, joint.rotational_stiffness(), joint.yield_moment()});
  }
  return joints;
}

// Who lies on each edge.
class Occupied {
 public:
  explicit Occupied(const Grid& grid) : grid_(grid) {}

  void take(const Path& along, const std::string& path) {
    const auto& points = along.points;
    for (std::size_t k = 0; k + (along.closed ? 0 : 1) < points.size(); ++k) {
      const auto a = points[k], b = points[(k + 1) % points.size()];
      const auto [owner, free] = owners_.try_emplace(std::minmax(a, b), path);
      require(
          free, path,
          fmt::format("lies on the side of a zone from ({:.6g}, {:.6g}) m to ({:.6g}, {:.6g}) m, where {} is "
                      "already; let only one of them run there",
                      grid_.x[a], grid_.y[a], grid_.x[b], grid_.y[b], owner->second));
    }
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
  occupied.take(along, path);
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

}  // namespace

Supports resolve_supports(const scene::Scene& scene, const Grid& grid) {
  const auto& linings = scene.continuum().linings();
  const auto& bolts = scene.continuum().bolts();
  Supports supports;
  if (linings.empty() && bolts.empty()) return supports;
  const Edges edges = number_edges(grid);
  Occupied occupied(grid);
  std::vector<LiningPlan> plans;
  for (int i = 0; i < linings.size(); ++i) {
    const auto& lining = linings[i];
    const auto path = fmt::format("continuum.linings[{}]", i);
    require(std::ranges::find(plans, lining.name(), &LiningPlan::name) == plans.end(), path + ".name",
            "`" + lining.name() + "` is taken by another lining; choose another one");
    const auto section = read_section(lining, path);
    const Section elastic = section
                                ? elastic_section(*section, lining)
                                : read_elastic_section(lining, scene.plane() == scene::PLANE_STRAIN, path);
    const Path along = read_path(lining.along(), grid, edges, path + ".along");
    occupied.take(along, path);
    require_statics(lining.stage(), scene, path);
    plans.push_back({lining.name(), along, elastic, read_joints(lining, along, grid, path),
                     lining.first_end_fixed(), lining.last_end_fixed(), section});
  }
  require_clear_joints(plans, grid);
  for (int i = 0; i < linings.size(); ++i) {
    supports.structures.set_stage(linings[i].stage());
    supports.linings.push_back(add_lining(plans[static_cast<std::size_t>(i)], grid, supports.structures));
  }
  for (int i = 0; i < bolts.size(); ++i) {
    const auto path = fmt::format("continuum.bolts[{}]", i);
    require_statics(bolts[i].stage(), scene, path);
    supports.structures.set_stage(bolts[i].stage());
    add_bolt(bolts[i], grid, edges, path, occupied, supports);
  }
  return supports;
}

}  // namespace adit::fdm
