// What observers see of particles in this process: histories, fragments, cracks and snapshots look at a run
// through it and never change it.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dem_server/laws/bond_state.hpp"
#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/packing/voronoi/voronoi_cells.hpp"
#include "dem_server/particles/particles.hpp"

namespace adit::dem {

// Two particles that a bond joins or joined, or that touch, as they are now: n from the first to the second
// centre, forces on the first without energy weight and dashpots.
struct ObservedPair {
  std::uint32_t first, second;
  double nx, ny;
  double normal, shear, moment;          // tension positive; along the left normal of n [N], [N m]
  double weight = 1;                     // energy weight
  BondState state = BondState::kIntact;  // of a bond
  bool touches = true;                   // its particles' surfaces press on each other
  bool resists_turning = false;          // as a parallel bond does
  // Of a facet: where its force acts [m], how wide it stands open and how far it has slipped [m].
  std::optional<PlaneVector> place = {};
  double opening = 0, slip = 0;
  // Of a facet that can break: the share of its strength that it uses, 1 once it has been beyond it.
  std::optional<double> demand = {};
};

// A force [N] on what is at (x_1, y_1), by what is at (x_2, y_2) [m]: a centre or a point on a wall.
struct Branch {
  double x_1, y_1, x_2, y_2, fx, fy;
};

// A smooth joint of two particles: its force on the first [N], how far it has slipped and opened since it was
// made [m].
struct JointForce {
  std::uint32_t first, second;
  double fx, fy;
  double normal, shear;  // along its normal and its plane [N]
  double slip, opening;
};

// A spring between two particles, tension positive [N].
struct SpringForce {
  std::uint32_t first, second;
  double force;
  double opening;  // [m]
  bool broken;
  std::optional<PlaneVector> direction;  // of the force; along the line of centres where absent
  std::string name;                      // empty: none
};

// An element of a bar between two particles: its ends at rest [m], and what it does now. Its force on the
// first particle acts in the middle between both ends, the pull along n, the unit vector from one end to the
// other, the dowel's force along the left normal; strain and stress of the bar, its slips in the particles
// along the path.
struct ObservedBar {
  std::uint32_t bar;
  bool whole;  // installed, and both particles are there
  std::uint32_t first, second;
  double x_1, y_1, x_2, y_2;
  double nx, ny, middle_x, middle_y;      // now [m]
  double pull, dowel;                     // [N]
  double stress, strain;                  // [Pa]
  double slip_1, slip_2, bond_1, bond_2;  // [m], bond stresses [Pa]
};

// The force of a wall on a particle [N] where it touches it [m].
struct WallTouch {
  std::uint32_t particle;
  double x, y, fx, fy;
};

// A facet between two cells that has cracked; its ends lie in the body at rest [m]. How wide it stands open
// at its wider end, and how far it has slipped [m]: half of its length at most, beyond which its faces have
// left each other.
struct ObservedCrack {
  std::uint32_t first, second;
  double x_1, y_1, x_2, y_2;
  double opening, slip;
  BondState mode;
  bool debonded = false;  // its cells are of two groups
  double length() const { return std::hypot(x_2 - x_1, y_2 - y_1); }
  PlaneVector middle() const { return {(x_1 + x_2) / 2, (y_1 + y_2) / 2}; }
};

struct WallForce {
  std::string name;
  double x, y;  // of the particles on it [N]
};

using SeePair = std::function<void(const ObservedPair&)>;

class Observable {
 public:
  virtual ~Observable() = default;
  virtual const Particles& particles() const = 0;
  virtual std::span<const std::uint32_t> group() const = 0;  // of each particle
  virtual std::span<const std::string> group_names() const = 0;
  // The share of the solid's area that each particle stands for [m^2].
  virtual std::vector<double> cell_areas() const = 0;

  // All bonds, whole or broken, in one order for good.
  virtual void for_each_bond(const SeePair& see) const = 0;
  // Those of these numbers in that order.
  virtual void see_bonds(std::span<const std::uint32_t> bonds, const SeePair& see) const = 0;
  // Particles that touch and were never joined.
  virtual void for_each_contact(const SeePair& see) const = 0;

  // Of cells; empty where particles are discs. Their turns since rest, and those at which displacements begin
  // to count [rad]; the latter empty: 0.
  virtual std::span<const CellOutline> outlines() const { return {}; }
  virtual std::span<const double> turn() const { return {}; }
  virtual std::span<const double> settled_turn() const { return {}; }
  virtual std::vector<ObservedCrack> cracks() const { return {}; }

  virtual std::vector<JointForce> joints() const { return {}; }
  virtual std::vector<WallTouch> wall_touches() const { return {}; }
  virtual std::vector<SpringForce> springs() const { return {}; }
  virtual std::vector<WallForce> walls() const { return {}; }
  // All elements, bar by bar along their paths.
  virtual std::vector<ObservedBar> bars() const { return {}; }
};

}  // namespace adit::dem
