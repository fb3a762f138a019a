// A lining, or a member: a chain of beams along grid points, open or closed, with joints at some of them.
//
// Beams that meet in a grid point turn together there, of one lining or of several. A joint within a lining
// stands between its two beams; what else ends there must be hinged to it. A joint at an end of a lining
// stands between this end and all that meets there without a joint, or has one of its own: two joints act
// one after the other. A joint of segments is within a lining, or at an end that cannot rotate, of which a
// plane of symmetry shows one half.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/structures/structures.hpp"
#include "fdm_server/supports/lining_section.hpp"
#include "protocol/geometry/shape.hpp"

namespace adit::fdm {

// Where a path turns by more than 40 degrees, as that of nine sides around a ring does, it has a corner: the
// cosine.
inline constexpr double kCorner = 0.766;

// Grid points in order; the last is joined to the first where the path is closed.
struct Path {
  std::vector<std::uint32_t> points;
  bool closed;

  std::size_t sides() const { return points.size() - (closed ? 0 : 1); }
  std::array<std::uint32_t, 2> side(std::size_t k) const {
    return {points[k], points[(k + 1) % points.size()]};
  }
};

struct LiningJoint {
  std::size_t node;  // place in the path
  double stiffness;  // [N m/rad], 0: a hinge
  double yield;      // moment [N m]
  // Of segments, which part; then there is no spring.
  std::shared_ptr<const JointLaw> segments = nullptr;
};

// From a node of a ring to that of the ring beside it.
struct RingDowel {
  std::size_t node;            // place in the path
  double stiffness, strength;  // of one dowel [N/m], [N]
};

struct LiningPlan {
  std::string name;
  Path path;
  Section elastic;
  std::vector<LiningJoint> joints;
  bool first_held, last_held;  // whether the ends of an open lining cannot rotate, with all joined rigidly
  std::shared_ptr<const LiningSection> section = nullptr;  // of reinforced concrete
  std::string bonded_to = {};                              // the lining below, whose points it has
  double spacing = 1;                                      // as of a lining
  bool follows_chord = false;                              // as members do
  std::optional<MemberStrength> strength{};                // if it may fail
  std::vector<RingDowel> dowels{};                         // to the ring beside it
};

struct Lining {
  std::string name;
  Path path;
  std::uint32_t first_beam, beams;                         // numbers in the structures
  std::shared_ptr<const LiningSection> section = nullptr;  // none: elastic
  std::string bonded_to = {};
  // Results are those of so much of the plane [m]: of a member, of a ring that has a half of each metre.
  double spacing = 1;
  std::vector<LiningJoint> joints{};
  std::optional<std::uint32_t> member{};  // its number in the structures, if it may fail
  // To the ring beside it: their nodes, the number of the first in the structures, and how wide a ring is: a
  // dowel's force times this is that of one dowel [m].
  std::vector<std::size_t> dowels{};
  std::uint32_t first_dowel = 0;
  double ring_width = 0;
};

// The node of a lining's path nearest to a place. UserError at `path`, the scene's field, where the place
// does not lie about as near as half a beam.
std::size_t nearest_node(const geometry::Point& place, const Path& lining, const Grid& grid,
                         const std::string& path);

// Joins the lining to those that were added before; the order does not matter.
Lining add_lining(const LiningPlan& plan, const Grid& grid, Structures& structures);

// The beams at a node, by their numbers in the structures: that which ends there, then that which begins.
struct BeamEnd {
  std::size_t beam, end;  // 0: the first end
};
std::vector<BeamEnd> beams_at(const Lining& lining, std::size_t node);

struct LiningForces {
  double thrust, moment, shear;  // [N], [N m], [N], signs as in beam.hpp
};

// What is carried at a node, in all of the lining's spacing: the mean of the beams on its two sides, or, at a
// corner, each of the two. Their thrusts have no common direction there: the mean of wall and roof is
// neither's.
struct NodeForces {
  std::array<LiningForces, 2> forces;
  std::size_t count;
};
NodeForces all_forces_at(const Lining& lining, const Structures& structures, std::size_t node);
// The one of them with the larger thrust by size.
LiningForces forces_at(const Lining& lining, const Structures& structures, std::size_t node);

}  // namespace adit::fdm
