#include "coupler/check/compare_ground.hpp"

#include <algorithm>

#include "coupler/bridging/overlap_ground.hpp"
#include "coupler/exchange/exchange.hpp"

namespace adit::coupler {
namespace {

// Zones by their centres; none where the participant does not draw their materials.
std::vector<GroundHere> drawn_ground(const wire::Snapshot& snapshot, const Side& side) {
  std::vector<GroundHere> zones;
  const double materials = side.part.continuum().materials_size();
  for (const wire::Piece& piece : snapshot.pieces()) {
    const auto& fields = piece.cell_fields();
    const auto material = std::ranges::find(fields, "material", &wire::Field::name);
    if (piece.shape() != wire::Piece::QUADS || material == fields.end()) continue;
    for (int zone = 0; 4 * zone < piece.connectivity_size(); ++zone) {
      const double number = material->values(zone);
      if (!(number >= 0 && number <= materials)) continue;
      GroundHere here{0, 0, ground_of_zones(side.part, side.path, static_cast<std::size_t>(number))};
      for (int corner = 4 * zone; corner < 4 * zone + 4; ++corner) {
        const int point = static_cast<int>(piece.connectivity(corner));
        here.x += piece.points(2 * point) / 4;
        here.y += piece.points(2 * point + 1) / 4;
      }
      zones.push_back(std::move(here));
    }
  }
  return zones;
}

}  // namespace

void compare_ground(Model& model) {
  std::vector<wire::Snapshot> snapshots;
  for (const Interface& interface : model.interfaces) {
    const Side outer = side_of(model.scene, model.participants[interface.outer]);
    const Side inner = side_of(model.scene, model.participants[interface.inner]);
    const bool is_known = StatedGround(outer.part, outer.path).is_known();
    if (!is_known && snapshots.empty()) snapshots = take_snapshots(model.participants);
    const auto warning = ground_warning(
        interface.overlap, outer, inner,
        is_known ? std::vector<GroundHere>{} : drawn_ground(snapshots[interface.outer], outer));
    if (warning) model.warnings.push_back(*warning);
  }
}

}  // namespace adit::coupler
