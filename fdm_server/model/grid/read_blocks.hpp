// A structured block of the scene.
#pragma once

#include <string>
#include <vector>

#include "fdm_server/meshing/mapped_block.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// One mapped block; of a ring four, counter-clockwise from its lower right corner. UserError below `path` for
// a shape without extent, arcs that miss their corners, divisions with zones of no size.
std::vector<MappedBlock> read_blocks(const scene::GridBlock& block, const std::string& path);

}  // namespace adit::fdm
