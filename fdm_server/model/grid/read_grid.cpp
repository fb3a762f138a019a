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
#include "protocol/machine/memory.hpp"
#include "protocol/wire/bounds.hpp"

namespace adit::fdm {
namespace {

using protocol::UserError;

// What a point with an elastic zone takes at least, with its snapshot, here and in a coupler beside it
// (docs/performance.md).
constexpr std::uint64_t kBytesPerPoint = 600;
// A model tells two numbers for each point, zone and edge, of which a block has one, one and two for each
// point.
constexpr std::uint64_t kModelBytes = 4 * 2 * sizeof(double);

std::uint64_t most_points() {
  return std::min(protocol::machine_bytes() / kBytesPerPoint, protocol::kMaxModelBytes / kModelBytes);
}

void require_size(double points, const std::string& path) {
  if (points > static_cast<double>(most_points()))
    throw UserError(
        path,
        fmt::format("makes {:.0f} grid points; at most {} can be computed on this machine, use larger zones",
                    points, most_points()));
}

// Not a whole number, in which the product of two large ones may wrap around to a small one.
double points_of(double zones_x, double zones_y) {
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
  double points = 0;
  for (int i = 0; i < scene.blocks_size(); ++i)
    for (auto& block : read_blocks(scene.blocks(i), fmt::format("continuum.blocks[{}]", i))) {
      points += points_of(static_cast<double>(block.along.zones), static_cast<double>(block.across.zones));
      require_size(points, "continuum.blocks");
      blocks.push_back(std::move(block));
      origin.push_back(i);
    }
  JoinedBlocks joined = join(blocks);
  require_sound(joined.grid, "continuum.blocks", [&](std::uint32_t zone) {
    const auto& first_zones = joined.first_zones;
    const auto b = std::ranges::upper_bound(first_zones, zone) - first_zones.begin() - 1;
    const std::string name = blocks[b].name.empty() ? "" : fmt::format(" (`{}`)", blocks[b].name);
    return fmt::format("zone {} of blocks[{}]{}",
                       zone - first_zones[std::ranges::find(origin, origin[b]) - origin.begin()], origin[b],
                       name);
  });
  return std::move(joined.grid);
}

Grid read_mesh(const scene::Mesh& mesh) {
  const std::string path = "continuum.mesh.path";
  MeshGrid read =
      read_gmsh(mesh.content(), std::filesystem::path(mesh.path()).filename().string(), path, most_points());
  require_sound(read.grid, path,
                [&](std::uint32_t zone) { return fmt::format("element {}", read.elements[zone]); });
  return std::move(read.grid);
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
