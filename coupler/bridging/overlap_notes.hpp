// What the user should know of an overlap that can be computed but is badly laid.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "coupler/bridging/overlap.hpp"

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

}  // namespace adit::coupler
