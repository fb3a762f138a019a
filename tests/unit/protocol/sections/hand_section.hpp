// Sections of the hand calculations as the product has them.
#pragma once

#include "hand.hpp"
#include "protocol/sections/capacity.hpp"

namespace adit::sections::test {

// A positive moment compresses the inner face, from which hand calculations count.
inline SectionShape shape_of(const HandSection& of) {
  SectionShape shape{of.thickness, of.width, {}};
  for (const auto& [depth, area] : of.bars) shape.bars.push_back({depth - of.thickness / 2, area, 0.02});
  return shape;
}

inline Capacity capacity_of(const HandSection& of) {
  return {shape_of(of), {{of.concrete, of.peak, of.ultimate, of.exponent}, of.modulus, of.steel, of.limit}};
}

// Seen from the other face.
inline HandSection turned(HandSection of) {
  for (HandBars& bars : of.bars) bars.depth = of.thickness - bars.depth;
  return of;
}

}  // namespace adit::sections::test
