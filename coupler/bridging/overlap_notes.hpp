// What the user should know of an overlap that can be computed but is badly laid.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupler/bridging/overlap.hpp"
#include "coupler/ground/stated_ground.hpp"

namespace adit::coupler {

// One of the two models that overlap.
struct Side {
  std::string name, path;           // path: in the scene
  scene::Scene part;                // with this model only, as `continuum` or `particles`
  std::span<const double> samples;  // x0 y0 x1 y1 … [m]
};

// One sentence each, where the overlap is narrower than the zones of a grid, so that its weights are felt in
// no zone as they are meant.
std::vector<std::string> overlap_notes(const Overlap& overlap, const Side& outer, const Side& inner);

// Ground that two models describe differently at one place.
struct GroundHere {
  double x, y;  // [m]
  Ground ground;
};

// One sentence on the place where the stiffness (Young's modulus and shear modulus) or the density of the two
// models differ most, by more than 5 %:
// - in the overlap, where both should model the same ground;
// - in its core, where particles that state no material of their own replace zones of another than the
//   scene's. What particles state there is meant, such as a lining.
// What the scene does not tell is not compared. `outer_ground`: where zones of the outer model are and of
// what, asked for where the scene alone does not tell it (StatedGround::is_known); an unknown inner model
// gives none.
std::optional<std::string> ground_warning(const Overlap& overlap, const Side& outer, const Side& inner,
                                          const std::vector<GroundHere>& outer_ground);

}  // namespace adit::coupler
