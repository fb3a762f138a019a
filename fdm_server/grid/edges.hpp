// The edges of a grid, each once, whichever zones share it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

struct Edges {
  std::vector<std::array<std::uint32_t, 4>> of_zone;  // side c of a zone runs from its point c to c + 1
  std::vector<Edge> list;                             // as sides of their first zones
  std::vector<std::uint8_t> zones;                    // that each is a side of, at most 255
};

// Edges are numbered as the zones' sides come.
Edges number_edges(const Grid& grid);

// The sides of one zone only.
std::vector<Edge> boundary(const Edges& edges);

}  // namespace adit::fdm
