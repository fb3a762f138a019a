// Several structured blocks become one grid.
#pragma once

#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/meshing/mapped_block.hpp"

namespace adit::fdm {

// The blocks one after another, points and zones row by row; points on their outlines that coincide, to a
// millionth of the shortest side of a zone, become one. Zones are counter-clockwise whichever way round their
// block is. `first_zones`: of each block.
struct JoinedBlocks {
  Grid grid;
  std::vector<std::uint32_t> first_zones;
};
JoinedBlocks join(const std::vector<MappedBlock>& blocks);

}  // namespace adit::fdm
