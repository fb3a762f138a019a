#include "fdm_server/model/water/at_rest.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fdm_server/model/grid/selection.hpp"
#include "protocol/ground/water_at_rest.hpp"

namespace adit::fdm {

WaterAtRest::WaterAtRest(const scene::Water& water, const Grid& grid,
                         std::span<const FreeFieldColumn> columns, std::uint32_t stage)
    : water_(&water) {
  for (int i = 0; i < water.places_size(); ++i) {
    const scene::WaterPlace& stated = water.places(i);
    if (stated.stage() > stage) continue;
    const auto path = fmt::format("water.places[{}].where", i);
    Place& place = places_.emplace_back(Place{&stated, std::vector<bool>(grid.zones.size(), false), {}});
    for (const auto zone : zones_in(grid, stated.where(), path)) place.zones[zone] = true;
    for (const FreeFieldColumn& column : columns)
      for (std::size_t k = 0; k < column.edges.size(); ++k)
        place.zones[column.zone(k)] = place.zones[column.edges[k].zone];
    if (!stated.where().has_group()) place.around.emplace(stated.where(), path, tolerance(grid));
  }
}

std::vector<double> WaterAtRest::pressures(const Grid& grid) const {
  std::vector<double> pressures;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const double y = centroid(corners(grid, z))[1];
    double pressure = protocol::pressure_at_rest(*water_, water_->level(), y);
    for (const auto& [stated, zones, around] : places_)
      if (zones[z])
        pressure = stated->has_pressure() ? stated->pressure()
                                          : protocol::pressure_at_rest(*water_, stated->level(), y);
    pressures.push_back(pressure);
  }
  return pressures;
}

double WaterAtRest::level_on(std::uint32_t zone, double x, double y) const {
  double level = water_->level();
  for (const auto& [stated, zones, around] : places_)
    if (stated->has_level() && (zones[zone] || (around && around->hold(x, y)))) level = stated->level();
  return level;
}

std::vector<bool> WaterAtRest::used() const {
  std::vector<bool> used;
  for (const Place& place : places_) used.push_back(std::ranges::count(place.zones, true) > 0);
  return used;
}

}  // namespace adit::fdm
