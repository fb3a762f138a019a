// Frictionless elastic discs in a box with rigid walls, brought to rest: what growing a packing needs.
//
// Two discs push each other apart by kn times their overlap, a wall pushes a disc by kn times what sticks
// out. Only ratios of forces matter to where the discs come to rest: kn = 1, and stresses come out as shares
// of kn.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem_server/packing/discs.hpp"
#include "dem_server/packing/random/pushes.hpp"
#include "protocol/geometry/bounding_box.hpp"
#include "protocol/threads/team.hpp"

namespace adit::dem {

class PressedDiscs {
 public:
  // Discs that are near each other should have near numbers: a step then finds them in the cache, and threads
  // share it. Where the discs come to rest does not depend on the number of threads. `team` outlives them.
  PressedDiscs(const Discs& discs, const geometry::BoundingBox& box, protocol::Team& team);

  void scale_radii(double factor);

  // Moves the discs towards the least energy until the mean unbalanced force of the discs is at most
  // `tolerance` times the mean contact force (or no contact carries anything), or `most_steps` are done.
  // True: at rest. Fast inertial relaxation: Bitzek, Koskinen, Gahler, Moseler & Gumbsch 2006, Phys. Rev.
  // Lett. 97, 170201.
  bool relax(double tolerance, std::uint32_t most_steps);

  // Mean normal stress of the walls at right angles to x and to y, over kn, compression positive.
  std::array<double, 2> wall_stress() const;

  std::size_t size() const { return radius_.size(); }
  Discs discs() const;
  std::vector<Pair> contacts() const;                // pairs that push each other
  std::vector<std::uint32_t> wall_contacts() const;  // of each disc

 private:
  void list_neighbours();
  bool neighbours_are_stale() const;
  double find_forces();

  std::vector<double> radius_;
  std::vector<Vector> place_, velocity_, force_;
  geometry::BoundingBox box_;
  double skin_;
  protocol::Team* team_;
  // Pairs within a block of discs, block by block, then those of two blocks; the distances at which they
  // touch; discs near walls; where those of each block begin, and the end.
  std::vector<Pair> neighbours_;
  std::vector<double> touch_;
  std::vector<std::uint32_t> at_walls_;
  std::vector<std::uint32_t> pair_starts_, wall_starts_;
  std::vector<Vector> listed_;  // where the discs were when neighbours were listed
  double farthest_ = 0;         // square of the longest way from there
};

}  // namespace adit::dem
