#include "fdm_server/model/boundaries/foundations.hpp"

#include <fmt/format.h>

#include <string>

#include "fdm_server/model/grid/selection.hpp"
#include "protocol/foundation/read.hpp"

namespace adit::fdm {
namespace {

std::vector<foundation::HeldPoint> held_points(const Grid& grid, const scene::Area& where,
                                               std::span<const double> weights, const std::string& path) {
  std::vector<double> held(grid.zones.size(), 0.0);
  for (const auto zone : select_zones(grid, where, path)) held[zone] = weights[zone];
  const auto areas = lumped_masses(grid, held, 1.0);
  std::vector<foundation::HeldPoint> points;
  for (std::uint32_t i = 0; i < areas.size(); ++i) points.push_back({i, areas[i], grid.x[i]});
  return points;
}

}  // namespace

std::vector<foundation::Springs> resolve_foundations(const scene::Continuum& scene, const Grid& grid,
                                                     std::span<const double> weights) {
  std::vector<foundation::Springs> springs;
  for (int i = 0; i < scene.foundations_size(); ++i) {
    const scene::Foundation& given = scene.foundations(i);
    const std::string path = fmt::format("continuum.foundations[{}]", i);
    const auto ground = foundation::read_ground(given, path);
    const auto points = held_points(grid, given.where(), weights, path + ".where");
    for (const auto& [direction, law] : foundation::read_laws(given, path))
      springs.emplace_back(direction, law, ground, points);
  }
  return springs;
}

}  // namespace adit::fdm
