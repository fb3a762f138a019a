#include "simplified/zoom/plan_joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "simplified/beam/elements/joint_springs.hpp"

namespace adit::simplified {
namespace {

const std::string kJoint = "joint";

// Bonds across the line keep the faces from touching and resist next to nothing [N/m].
constexpr double kSoft = 1;

// Parts of the keys.
constexpr int kKeys = 8;

// The curve goes on with its outer slopes, which the scene states by a point on either side [m].
constexpr double kBeyond = 1;

// Curves that act side by side, each with its share.
struct Side {
  beam::Curve curve;
  double share;
};

double force(const std::vector<Side>& sides, double opening) {
  double sum = 0;
  for (const Side& side : sides) sum += side.share * side.curve.force(opening);
  return sum;
}

scene::ForceCurve force_curve(const std::vector<Side>& sides) {
  std::set<double> corners;
  for (const Side& side : sides)
    for (const beam::CurvePoint& point : side.curve.points) corners.insert(point.elongation);
  corners.insert({*corners.begin() - kBeyond, *corners.rbegin() + kBeyond});
  scene::ForceCurve curve;
  for (const double opening : corners) {
    curve.add_opening(opening);
    curve.add_force(force(sides, opening));
  }
  return curve;
}

// The rows beside a place and the share of each, so that both together act at the place; the outermost row
// alone beyond it.
std::map<int, double> shares(const PlanPacking& packing, double y) {
  const double at =
      std::clamp((y - packing.row(0)) / (packing.row(1) - packing.row(0)), 0.0, packing.rows - 1.0);
  const int below = static_cast<int>(at);
  std::map<int, double> rows{{below, below + 1 - at}};
  if (at > below) rows[below + 1] = at - below;
  return rows;
}

void observe(const std::string& name, scene::Quantity quantity, scene::Particles& particles) {
  scene::History& history = *particles.add_histories();
  history.set_name(name);
  history.set_quantity(quantity);
  if (quantity == scene::SPRING_FORCE)
    history.set_spring(name);
  else
    history.set_joint(name);
}

scene::ParticleSpring& add_spring(const std::string& name, int row, const PlanPacking& packing,
                                  scene::Particles& particles) {
  scene::ParticleSpring& spring = *particles.add_springs();
  spring.set_name(name);
  for (auto* end : {spring.mutable_from(), spring.mutable_to()}) end->set_y(packing.row(row));
  spring.mutable_from()->set_x(packing.joint - packing.radius());
  spring.mutable_to()->set_x(packing.joint + packing.radius());
  observe(name, scene::SPRING_FORCE, particles);
  return spring;
}

void add_line(const PlanPacking& packing, scene::Particles& particles) {
  scene::ParticleJoint& line = *particles.add_joints();
  line.set_name(kJoint);
  // From the upper end down, so that what lies towards larger chainages is the far face, on the left.
  for (auto* end : {line.mutable_from(), line.mutable_to()}) end->set_x(packing.joint);
  line.mutable_from()->set_y(packing.width);
  line.mutable_to()->set_y(-packing.width);
  line.mutable_bonds()->set_normal_stiffness(kSoft);
  line.mutable_bonds()->set_shear_stiffness(0);
  for (const auto quantity : {scene::OPENING, scene::OFFSET, scene::ROTATION})
    observe(kJoint, quantity, particles);
}

void add_axial(const std::string& kind, std::span<const beam::Joint::Spring> springs,
               const PlanPacking& packing, scene::Particles& particles) {
  std::map<int, std::vector<Side>> rows;
  for (const auto& spring : springs)
    for (const auto& [row, share] : shares(packing, spring.y)) rows[row].push_back({spring.curve, share});
  int number = 0;
  for (const auto& [row, sides] : rows) {
    scene::ParticleSpring& spring = add_spring(fmt::format("{}_{}", kind, ++number), row, packing, particles);
    *spring.mutable_curve() = force_curve(sides);
    spring.mutable_direction()->set_x(1);
    spring.mutable_direction()->set_y(0);
  }
}

// In equal parts at equal distances over the faces: at one place the full force would dent the bodies there.
void add_keys(const scene::ShearKeys& keys, const PlanPacking& packing, scene::Particles& particles) {
  std::map<int, double> rows;
  for (int part = 0; part < kKeys; ++part)
    for (const auto& [row, share] : shares(packing, packing.width * ((part + 0.5) / kKeys - 0.5)))
      rows[row] += share / kKeys;
  int number = 0;
  for (const auto& [row, share] : rows) {
    scene::ParticleSpring& spring = add_spring(fmt::format("key_{}", ++number), row, packing, particles);
    spring.set_stiffness(share * keys.stiffness());
    spring.set_tension_only(false);
    if (keys.clearance() > 0) spring.set_clearance(keys.clearance());
    spring.mutable_direction()->set_x(0);
    spring.mutable_direction()->set_y(1);
  }
}

}  // namespace

double PlanPacking::radius() const {
  return width / (rows * std::numbers::sqrt3);
}

double PlanPacking::row(int number) const {
  return width * ((number + 0.5) / rows - 0.5);
}

void add_joint(const beam::Joint& joint, const scene::Joints& group, const PlanPacking& packing,
               scene::Particles& particles) {
  add_line(packing, particles);
  const auto springs = beam::axial_springs(joint);
  const auto gaskets = std::span(springs).first(joint.gaskets.size());
  add_axial("gasket", gaskets, packing, particles);
  add_axial("spring", std::span(springs).subspan(gaskets.size()), packing, particles);
  if (group.has_lateral_keys()) add_keys(group.lateral_keys(), packing, particles);
}

}  // namespace adit::simplified
