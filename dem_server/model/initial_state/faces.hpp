// The faces into which the links between discs cut the plane: pores inside, and what lies beyond.
//
// Links are the edges of a plane graph, where of two that cross only the shorter one counts. A face with many
// sides is a hole or the outside; the discs around it are a border, beyond which ground or supports carry
// what links do not. A force f along the branch l of a link between two faces carries half of f l on either
// side of it, so that the mean stress over the faces inside is exactly sum(share f l) / area of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/model/initial_state/network.hpp"
#include "dem_server/packing/discs.hpp"

namespace adit::dem {

struct Face {
  double area, x, y;                   // [m^2], mean place of its discs [m]
  std::vector<std::uint32_t> corners;  // its discs, counter-clockwise
};

struct Faces {
  std::vector<bool> border;   // of each disc
  std::vector<double> share;  // of each link, on faces inside: 0, 1/2 or 1
  std::vector<Face> inside;
};

Faces find_faces(const Discs& discs, std::span<const Link> links);

}  // namespace adit::dem
