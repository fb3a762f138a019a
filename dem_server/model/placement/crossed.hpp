// Which particles a line passes through, and where.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/model/model.hpp"
#include "protocol/geometry/shape.hpp"

namespace adit::dem {

// A particle on the line from `begin` to `end`, counted from the line's first point [m].
struct Crossed {
  std::uint32_t disc;
  double begin, end;
  double middle() const { return (begin + end) / 2; }
  double length() const { return end - begin; }
};

// Along a line of straight pieces, in their order; a particle that it enters again counts again. Cells have
// their outlines, other particles are discs.
std::vector<Crossed> crossed_by(std::span<const geometry::Point> line, const Model& model);

// The place on the line at a distance from its first point [m]; a negative one counts from its last.
geometry::Point place_on(std::span<const geometry::Point> line, double distance);
double length_of(std::span<const geometry::Point> line);

}  // namespace adit::dem
