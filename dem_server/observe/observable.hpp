// What observers see of particles in this process: histories, fragments, cracks and snapshots look at a run
// through it and never change it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "dem_server/laws/bond_state.hpp"
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
};

// A force [N] on what is at (x_1, y_1), by what is at (x_2, y_2) [m]: a centre or a point on a wall.
struct Branch {
  double x_1, y_1, x_2, y_2, fx, fy;
};

// The force of a smooth joint on the first of two particles [N].
struct JointForce {
  std::uint32_t first, second;
  double fx, fy;
};

// A spring between two centres, tension positive [N].
struct SpringForce {
  std::uint32_t first, second;
  double force;
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

  // All bonds, whole or broken, in one order for good.
  virtual void for_each_bond(const SeePair& see) const = 0;
  // Those of these numbers in that order.
  virtual void see_bonds(std::span<const std::uint32_t> bonds, const SeePair& see) const = 0;
  // Particles that touch and were never joined.
  virtual void for_each_contact(const SeePair& see) const = 0;

  virtual std::vector<JointForce> joints() const { return {}; }
  virtual std::vector<Branch> branches_of_walls() const { return {}; }
  virtual std::vector<SpringForce> springs() const { return {}; }
  virtual std::vector<WallForce> walls() const { return {}; }
};

}  // namespace adit::dem
