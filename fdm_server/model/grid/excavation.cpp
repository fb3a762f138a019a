#include "fdm_server/model/grid/excavation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "fdm_server/grid/edges.hpp"
#include "fdm_server/model/grid/selection.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"

namespace adit::fdm {
namespace {

std::string path_of(int excavation) {
  return fmt::format("continuum.excavations[{}]", excavation);
}

}  // namespace

void leave_out(const scene::Continuum& scene, Grid& grid) {
  std::vector<double> there(grid.zones.size(), 1.0);
  bool changed = false;
  for (int i = 0; i < scene.excavations_size(); ++i) {
    if (scene.excavations(i).stage() > 0) continue;
    for (const auto zone : select_zones(grid, scene.excavations(i).where(), path_of(i) + ".where"))
      there[zone] = 0;
    changed = true;
  }
  if (!changed) return;
  compact(grid, there);
  if (grid.zones.empty())
    throw protocol::UserError("continuum.excavations", "leave no zone; give smaller areas");
  grid.boundary = boundary(number_edges(grid));
}

ExcavatedZones excavated_zones(const scene::Scene& scene, const Grid& grid) {
  ExcavatedZones zones{std::vector<std::uint32_t>(grid.zones.size(), 0),
                       std::vector<double>(grid.zones.size(), 0.0)};
  auto& stages = zones.stage;
  const auto& excavations = scene.continuum().excavations();
  for (int i = 0; i < excavations.size(); ++i) {
    const std::uint32_t stage = excavations[i].stage();
    if (stage == 0) continue;
    protocol::require_statics(scene, stage, path_of(i));
    for (const auto zone : select_zones(grid, excavations[i].where(), path_of(i) + ".where"))
      if (stages[zone] == 0 || stage < stages[zone]) {
        stages[zone] = stage;
        zones.held[zone] = 1 - excavations[i].released();
      }
  }
  if (!stages.empty() && std::ranges::find(stages, 0u) == stages.end())
    throw protocol::UserError("continuum.excavations", "leave no zone; give smaller areas");
  return zones;
}

}  // namespace adit::fdm
