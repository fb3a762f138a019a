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
#include "protocol/geometry/bounding_box.hpp"

namespace adit::dem {

class PressedDiscs {
 public:
  PressedDiscs(Discs discs, const geometry::BoundingBox& box);

  void scale_radii(double factor);

  // Moves the discs towards the least energy until the mean unbalanced force of the discs is at most
  // `tolerance` times the mean contact force (or no contact carries anything), or `most_steps` are done.
  // True: at rest. Fast inertial relaxation: Bitzek, Koskinen, Gahler, Moseler & Gumbsch 2006, Phys. Rev.
  // Lett. 97, 170201.
  bool relax(double tolerance, std::uint32_t most_steps);

  // Mean normal stress of the walls at right angles to x and to y, over kn, compression positive.
  std::array<double, 2> wall_stress() const;

  const Discs& discs() const { return discs_; }
  std::vector<Pair> contacts() const;                // pairs that push each other
  std::vector<std::uint32_t> wall_contacts() const;  // of each disc

 private:
  struct Forces {
    double unbalanced = 0, contact = 0;  // mean of the discs, mean of the contacts
  };
  void list_neighbours();
  bool neighbours_are_stale() const;
  Forces add_forces();

  Discs discs_;
  geometry::BoundingBox box_;
  double skin_;
  std::vector<Pair> neighbours_;
  std::vector<double> listed_x_, listed_y_;  // where the discs were when neighbours were listed
  std::vector<double> fx_, fy_, vx_, vy_;
};

}  // namespace adit::dem
