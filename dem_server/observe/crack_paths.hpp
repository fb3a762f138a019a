// Cracks between cells that meet, joined to paths. Facets of Voronoi meet at the corners of their cells, so
// that a fracture is a path of many facets; it may branch. Where a group has debonded from another is no
// path: it would join the cracks that end there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/observe/observable.hpp"

namespace adit::dem {

struct CrackPath {
  std::size_t cracks;
  BondState mode;        // of most of its length
  double length;         // of all its cracks [m]
  double opening, slip;  // the largest, slip without sign [m]
  double x, y;           // the middle of its widest crack in the body at rest [m]
};

struct CrackPaths {
  std::vector<std::uint32_t> number;  // of each crack: its path, from 1; 0: it has debonded
  std::vector<CrackPath> paths;       // the longest first; of equal ones that of the first crack
};

// Ends meet within 1e-5 of the cracks' mean length: VoronoiCells leaves out shorter facets between them.
CrackPaths paths_of(std::span<const ObservedCrack> cracks);

}  // namespace adit::dem
