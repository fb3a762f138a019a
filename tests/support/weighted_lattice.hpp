// What of a lattice exists in an overlap whose inner model it is.
#pragma once

#include <span>

#include "coupler/bridging/overlap.hpp"
#include "dem_server/model/sample_points.hpp"
#include "tests/support/lattice_model.hpp"
#include "tests/support/overlaps.hpp"

namespace adit::dem::test {

inline Assembly weighted_lattice(const Model& model, const coupler::Overlap& overlap, double floor) {
  const auto weights = adit::test::inner_weights(overlap, sample_points(model));
  const std::size_t centres = model.discs.size();
  return assemble(model, 1.0,
                  {std::span(weights).first(centres), std::span(weights).subspan(centres), floor});
}

}  // namespace adit::dem::test
