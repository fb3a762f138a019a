// Water at rest in one stage: the level of the scene, and the places that have a level or a pressure of their
// own from a stage on. The last place counts.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/boundaries/free_field.hpp"
#include "fdm_server/grid/grid.hpp"
#include "protocol/geometry/selection.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

class ZoneLocator;

class WaterAtRest {
 public:
  // Columns have the water of the side that they go on from. UserError at the place that selects badly.
  WaterAtRest(const scene::Water& water, const Grid& grid, std::span<const FreeFieldColumn> columns,
              std::uint32_t stage);

  // At the centre of each zone [Pa]; 0 above the level.
  std::vector<double> pressures() const;
  // At the height y below a level [Pa]; 0 above it.
  double pressure_below(double level, double y) const;

  // The level of the water that stands at (x, y), outside of the ground, above this zone if above any [m]:
  // that of the last place with a level that holds (x, y), else that of the zone. Of groups also zones that
  // were taken away hold what lies in them.
  double level_at(double x, double y, std::optional<std::uint32_t> above) const;

  // Whether each place selects any zone.
  std::vector<bool> used() const;

 private:
  struct Place {
    const scene::WaterPlace* stated;
    std::vector<bool> zones;                 // that it holds
    std::optional<protocol::Places> around;  // absent where it is a group of zones
  };
  bool holds(const Place& place, double x, double y) const;
  // Of the last place with a level for which a statement holds.
  template <class Statement>
  std::optional<double> last_level(Statement&& statement) const;

  const scene::Water* water_;
  const Grid* grid_;
  std::vector<Place> places_;
  std::shared_ptr<const ZoneLocator> locator_;  // where a place is a group
};

}  // namespace adit::fdm
