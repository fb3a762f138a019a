// Grids from Gmsh: the MSH format 4.1 in ASCII (gmsh.info/doc/texinfo/gmsh.html#MSH-file-format).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

struct MeshGrid {
  Grid grid;
  std::vector<std::int64_t> elements;  // Gmsh's number of each zone
};

// The mesh's quadrilaterals of four nodes, in the file's order, in the plane z = 0; nodes without one are
// left out. Physical surfaces become groups of zones, physical curves groups of edges; those without a name
// have their number as name, and surfaces and curves of one name are one group. The quadrilaterals of a
// surface are turned counter-clockwise together.
//
// UserError at `path` with the file's `name` and line for other versions and element types, broken text,
// nodes that do not exist, a mesh with more than `most_points` nodes. Whether the zones fit together is not
// asked here.
MeshGrid read_gmsh(std::string_view text, const std::string& name, const std::string& path,
                   std::size_t most_points);

}  // namespace adit::fdm
