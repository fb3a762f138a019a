// The scene's linings and bolts on the grid.
// Errors: UserError with the scene's path where a lining lies on no edges, two lie on the same, a joint lies
// off its lining, or a section or stiffness is impossible.
#pragma once

#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/lining.hpp"
#include "protocol/geometry/shape.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

struct BoltBars {
  Path path;
  std::uint32_t first_bar, bars;  // numbers in the structures
  double spacing;                 // a bar's thrust times this is that of one bolt [m]
};

struct Supports {
  Structures structures{};
  std::vector<Lining> linings{};
  std::vector<BoltBars> bolts{};
};

// The node of a lining nearest to a place, which must lie about as near as half a beam.
std::size_t nearest_node(const geometry::Point& place, const Path& lining, const Grid& grid,
                         const std::string& path);

Supports resolve_supports(const scene::Scene& scene, const Grid& grid);

}  // namespace adit::fdm
