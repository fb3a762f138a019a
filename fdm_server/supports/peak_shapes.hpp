// How far closed linings were pushed out of shape since time began.
//
// A circle ovals: its radial displacements are c + a cos 2t + b sin 2t and other harmonics; the diameter in
// the direction t changes by 2 (a cos 2t + b sin 2t) beside its mean change 2 c, most in the direction with
// tan 2t = b/a, by 2 sqrt(a^2 + b^2). Integrals around the lining are sums over its nodes, each with half of
// both sides at it. Any other lining racks: its highest nodes move aside against its lowest ones.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/lining.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class PeakShapes {
 public:
  struct Peak {
    double size;   // ovaling; racking with its sign, positive if the top moves along x [m]
    double angle;  // of the direction in which the diameter grew most, from x, in (-pi/2, pi/2]; 0 of racking
    double time;   // [s]
  };

  // Nothing of open linings.
  PeakShapes(const Grid& grid, std::span<const Lining> linings);
  // Takes the peaks of a step from the displacements of the grid's points, which count from time 0 [m].
  void take(std::span<const double> ux, std::span<const double> uy, double time);

  bool ovals(std::size_t lining) const { return outlines_[lining] && outlines_[lining]->round; }
  // Of a lining by its number; none of an open one, or before the first step.
  std::optional<Peak> of(std::size_t lining) const;

  void exchange(state::Archive& archive);

 private:
  struct Outline {
    struct Node {
      std::uint32_t point;
      double radial_x, radial_y;  // from the middle, of length 1
      double share;               // of the whole length
    };
    bool round;
    std::vector<Node> nodes;
    std::vector<std::uint32_t> top, bottom;
    Peak now(std::span<const double> ux, std::span<const double> uy, double time) const;
  };
  static Outline outline(const Grid& grid, const Path& path);

  std::vector<std::optional<Outline>> outlines_;  // of each lining
  std::vector<Peak> peaks_;                       // of each lining; empty before the first step
};

}  // namespace adit::fdm
