#include "fdm_server/model/grid/excavation.hpp"

#include <fmt/format.h>

#include <vector>

#include "fdm_server/grid/edges.hpp"
#include "fdm_server/model/grid/selection.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {

void leave_out(const scene::Continuum& scene, Grid& grid) {
  std::vector<double> there(grid.zones.size(), 1.0);
  bool changed = false;
  for (int i = 0; i < scene.excavations_size(); ++i) {
    if (scene.excavations(i).stage() > 0) continue;
    for (const auto zone :
         select_zones(grid, scene.excavations(i).where(), fmt::format("continuum.excavations[{}].where", i)))
      there[zone] = 0;
    changed = true;
  }
  if (!changed) return;
  for (int i = 0; i < scene.materials_size(); ++i)
    if (scene.materials(i).stage() > 0)
      for (const auto zone :
           select_zones(grid, scene.materials(i).where(), fmt::format("continuum.materials[{}].where", i)))
        there[zone] = 1;
  compact(grid, there);
  if (grid.zones.empty())
    throw protocol::UserError("continuum.excavations", "leave no zone; give smaller areas");
  grid.boundary = boundary(number_edges(grid));
}

}  // namespace adit::fdm
