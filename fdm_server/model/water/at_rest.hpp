// Water at rest in one stage: the level of the scene, and the places that have a level or a pressure of their
// own from a stage on. The last place of a zone counts.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/boundaries/free_field.hpp"
#include "fdm_server/grid/grid.hpp"
#include "protocol/geometry/selection.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

class WaterAtRest {
 public:
  // Columns have the water of the side that they go on from. UserError at the place that selects badly.
  WaterAtRest(const scene::Water& water, const Grid& grid, std::span<const FreeFieldColumn> columns,
              std::uint32_t stage);

  // At the centre of each zone [Pa]; 0 above the level.
  std::vector<double> pressures(const Grid& grid) const;

  // The level of the water that stands at (x, y), outside of the ground, on this zone [m]: that of the last
  // place that holds either of them.
  double level_on(std::uint32_t zone, double x, double y) const;

  // Whether each place selects any zone.
  std::vector<bool> used() const;

 private:
  struct Place {
    const scene::WaterPlace* stated;
    std::vector<bool> zones;                 // that it holds
    std::optional<protocol::Places> around;  // absent where it is a group of zones
  };

  const scene::Water* water_;
  std::vector<Place> places_;
};

}  // namespace adit::fdm
