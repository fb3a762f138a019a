#include "coupler/tunnel/joints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "coupler/tunnel/parts.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using geometry::Point;
using protocol::UserError;

// Springs across a joint, by their names.
class Joint {
 public:
  Joint(const scene::LinedTunnel& tunnel, const Contour::Cut& cut, std::size_t number,
        scene::Particles& particles)
      : tunnel_(tunnel), cut_(cut), number_(number), particles_(particles) {}

  void add_line() {
    auto& line = *particles_.add_joints();
    *line.mutable_from() = point(cut_.at(-grain_radius(tunnel_)));
    *line.mutable_to() = point(cut_.at(tunnel_.lining().thickness()));
    line.set_open(true);
    line.set_name(part_name(tunnel_, "joint", number_));
  }

  void add_bolt(const scene::SegmentBolts& bolts) {
    auto& spring = add_spring(bolts.length() / 2);
    spring.set_name(part_name(tunnel_, "bolt", number_));
    spring.set_stiffness(bolts.stiffness());
    if (bolts.has_pretension()) spring.set_pretension(bolts.pretension());
    if (bolts.has_strength()) spring.set_strength(bolts.strength());
  }

  void add_gasket(const scene::ForceCurve& curve) {
    auto& spring = add_spring(kBesideJoint * grain_radius(tunnel_));
    spring.set_name(part_name(tunnel_, "gasket", number_));
    spring.set_tension_only(false);
    *spring.mutable_curve() = curve;
    *spring.mutable_direction() = point({-cut_.ny, cut_.nx});
  }

  void add_key(const scene::SegmentKeys& keys) {
    auto& spring = add_spring(kBesideJoint * grain_radius(tunnel_));
    spring.set_name(part_name(tunnel_, "key", number_));
    spring.set_tension_only(false);
    spring.set_stiffness(keys.stiffness());
    if (keys.has_clearance()) spring.set_clearance(keys.clearance());
    if (keys.has_strength()) spring.set_strength(keys.strength());
    *spring.mutable_direction() = point({cut_.nx, cut_.ny});
  }

  // Springs along the lining. Together they resist a rotation by the sum of k a^2, a their distances from the
  // middle. They end inside the segments, because grains at the faces of a joint may roll.
  void add_neighbours(const scene::NeighbourRings& neighbours) {
    const double thickness = tunnel_.lining().thickness(), radius = grain_radius(tunnel_);
    const double rows = std::max(1.0, std::floor(thickness / (std::numbers::sqrt3 * radius) + 1e-6));
    const int last = static_cast<int>(kSpringsInARow * rows) - 1;
    const double reach = std::max(thickness / 2 - kNearestCentre * radius, thickness / 4);
    const auto arm = [&](int k) { return reach * (2.0 * k / last - 1); };
    double squares = 0;
    for (int k = 0; k <= last; ++k) squares += arm(k) * arm(k);
    for (int k = 0; k <= last; ++k) {
      auto& spring = add_spring(kInsideSegment * radius, arm(k));
      spring.set_tension_only(false);
      spring.set_stiffness(neighbours.rotational_stiffness() / squares);
      *spring.mutable_direction() = point({-cut_.ny, cut_.nx});
    }
  }

 private:
  // The particle nearest to a place so far from a joint lies on the same side of it.
  static constexpr double kBesideJoint = 1.5;
  static constexpr double kInsideSegment = 4;  // beyond the two outermost layers of particles
  // Springs end at the nearest particles. With three to a row of particles these errors average out: the
  // stiffness is right within 8 %, at any angle, in six rows.
  static constexpr int kSpringsInARow = 3;

  // Between places beside the joint, `outside` the middle of the lining.
  scene::ParticleSpring& add_spring(double beside, double outside = 0) {
    const Point middle = cut_.at(tunnel_.lining().thickness() / 2 + outside);
    auto& spring = *particles_.add_springs();
    *spring.mutable_from() = point({middle.x + beside * cut_.ny, middle.y - beside * cut_.nx});
    *spring.mutable_to() = point({middle.x - beside * cut_.ny, middle.y + beside * cut_.nx});
    if (tunnel_.stage() > 0) spring.set_stage(stage_of_lining(tunnel_));
    return spring;
  }

  const scene::LinedTunnel& tunnel_;
  const Contour::Cut cut_;
  const std::size_t number_;
  scene::Particles& particles_;
};

}  // namespace

namespace {

template <class Stated>
std::vector<double> angles_of(const Stated& ring, std::uint32_t segments) {
  if (ring.joints_size() > 0) return {ring.joints().begin(), ring.joints().end()};
  std::vector<double> angles;
  if (segments < 2) return angles;
  for (std::uint32_t k = 0; k < segments; ++k)
    angles.push_back(ring.first_joint() + k * 2 * std::numbers::pi / segments);
  return angles;
}

}  // namespace

std::vector<double> joint_angles(const scene::TunnelLining& lining) {
  return angles_of(lining, lining.segments());
}

std::vector<double> joint_angles(const scene::TunnelLining& lining, const scene::SecondRing& ring) {
  return angles_of(ring, lining.segments());
}

void require_joints_possible(const scene::LinedTunnel& tunnel, const std::string& path) {
  const scene::TunnelLining& lining = tunnel.lining();
  const std::string at = path + ".lining.";
  if (lining.joints_size() > 0 && (lining.has_segments() || lining.has_first_joint()))
    throw UserError(at + "joints",
                    "is given beside `segments` or `first_joint`; give equal segments or angles");
  const bool jointed = !joint_angles(lining).empty();
  if (jointed && !tunnel.has_circle())
    throw UserError(at + (lining.joints_size() > 0 ? "joints" : "segments"),
                    "is given, but only the lining of a circle has segments; leave it out");
  for (const auto& [given, field] :
       {std::pair{lining.has_bolts(), "bolts"}, std::pair{lining.has_gasket(), "gasket"},
        std::pair{lining.has_keys(), "keys"}, std::pair{lining.has_neighbours(), "neighbours"},
        std::pair{lining.has_contact(), "contact"}, std::pair{lining.has_second_ring(), "second_ring"}})
    if (given && !jointed)
      throw UserError(at + field, "is given, but the lining has no joints; give `segments` or `joints`");
}

void require_second_ring_possible(const scene::TunnelLining& lining, const std::string& path) {
  if (!lining.has_second_ring()) return;
  const scene::SecondRing& ring = lining.second_ring();
  const std::string at = path + ".lining.second_ring";
  protocol::require(lining.has_interface(), at,
                    "is given, but the lining is tied to the ground, so that its rings cannot move apart; "
                    "give `lining.interface`");
  protocol::require(ring.joints_size() == 0 || !ring.has_first_joint(), at + ".joints",
                    "is given beside `first_joint`; give equal segments or angles");
  protocol::require(ring.joints_size() > 0 || lining.segments() > 1, at + ".joints",
                    "is missing; give the angles of its joints, as those of the first ring");
  protocol::require(ring.dowels() == 0 || ring.has_dowel_stiffness(), at + ".dowel_stiffness",
                    "is missing; give the stiffness of one of the dowels");
}

void add_joints(const scene::LinedTunnel& tunnel, const Contour& contour, const std::string& path,
                scene::Particles& particles) {
  require_joints_possible(tunnel, path);
  const scene::TunnelLining& lining = tunnel.lining();
  std::size_t number = 0;
  for (const double angle : joint_angles(lining)) {
    Joint joint(tunnel, contour.cut_at_angle(angle), ++number, particles);
    joint.add_line();
    if (lining.has_bolts()) joint.add_bolt(lining.bolts());
    if (lining.has_gasket()) joint.add_gasket(lining.gasket());
    if (lining.has_keys()) joint.add_key(lining.keys());
    if (lining.has_neighbours()) joint.add_neighbours(lining.neighbours());
  }
}

}  // namespace adit::coupler
