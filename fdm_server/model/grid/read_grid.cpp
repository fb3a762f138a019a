#include "fdm_server/model/grid/read_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "fdm_server/grid/checks.hpp"
#include "fdm_server/meshing/blocks.hpp"
#include "fdm_server/meshing/gmsh.hpp"
#include "fdm_server/model/grid/excavation.hpp"
#include "fdm_server/model/grid/read_blocks.hpp"
#include "protocol/errors.hpp"
#include "protocol/wire/frame.hpp"

namespace adit::fdm {
namespace {

using protocol::UserError;

// A snapshot travels in one frame.
constexpr std::uint64_t kBytesPerPoint = 180, kMostPoints = protocol::kMaxFrameBytes / kBytesPerPoint;

void require_size(std::uint64_t points, const std::string& path) {
  if (points > kMostPoints)
    throw UserError(path, fmt::format("makes {} grid points; at most {} can be computed, use larger zones",
                                      points, kMostPoints));
}

std::uint64_t points_of(std::uint64_t zones_x, std::uint64_t zones_y) {
  return (zones_x + 1) * (zones_y + 1);
}

Grid read_block(const scene::Block& block) {
  require_size(points_of(block.zones_x(), block.zones_y()), "continuum.block");
  return make_grid(
      {block.x_min(), block.x_max(), block.y_min(), block.y_max(), block.zones_x(), block.zones_y()});
}

Grid read_several(const scene::Continuum& scene) {
  std::vector<MappedBlock> blocks;
  std::vector<int> origin;  // of each: its number in the scene
  std::uint64_t points = 0;
  for (int i = 0; i < scene.blocks_size(); ++i)
    for (auto& block : read_blocks(scene.blocks(i), fmt::format("continuum.blocks[{}]", i))) {
      points += points_of(block.along.zones, block.across.zones);
      require_size(points, "continuum.blocks");
      blocks.push_back(std::move(block));
      origin.push_back(i);
    }
  auto [grid, first_zones] = join(blocks);
  require_sound(grid, "continuum.blocks", [&](std::uint32_t zone) {
    const auto b = std::ranges::upper_bound(first_zones, zone) - first_zones.begin() - 1;
    const std::string name = blocks[b].name.empty() ? "" : fmt::format(" (`{}`)", blocks[b].name);
    return fmt::format("zone {} of blocks[{}]{}",
                       zone - first_zones[std::ranges::find(origin, origin[b]) - origin.begin()], origin[b],
                       name);
  });
  return std::move(grid);
}

Grid read_mesh(const scene::Mesh& mesh) {
  const std::string path = "continuum.mesh.path";
  auto [grid, elements] =
      read_gmsh(mesh.content(), std::filesystem::path(mesh.path()).filename().string(), path, kMostPoints);
  require_sound(grid, path, [&](std::uint32_t zone) { return fmt::format("element {}", elements[zone]); });
  return std::move(grid);
}

}  // namespace

Grid read_grid(const scene::Continuum& scene) {
  const int given = int{scene.has_block()} + int{scene.blocks_size() > 0} + int{scene.has_mesh()};
  if (given != 1)
    throw UserError("continuum", given == 0 ? "has no grid; give block, blocks or mesh"
                                            : "has more than one grid; keep one of block, blocks and mesh");
  Grid grid = scene.has_mesh()    ? read_mesh(scene.mesh())
              : scene.has_block() ? read_block(scene.block())
                                  : read_several(scene);
  leave_out(scene, grid);
  return grid;
}

}  // namespace adit::fdm
