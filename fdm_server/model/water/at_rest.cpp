#include "fdm_server/model/water/at_rest.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fdm_server/grid/locate.hpp"
#include "fdm_server/model/grid/selection.hpp"
#include "protocol/ground/water_at_rest.hpp"

namespace adit::fdm {
WaterAtRest::WaterAtRest(const scene::Water& water, const Grid& grid,
                         std::span<const FreeFieldColumn> columns, std::uint32_t stage)
    : water_(&water), grid_(&grid) {
  for (int i = 0; i < water.places_size(); ++i) {
    const scene::WaterPlace& stated = water.places(i);
    if (stated.stage() > stage) continue;
    const auto path = fmt::format("water.places[{}].where", i);
    Place& place = places_.emplace_back(Place{&stated, std::vector<bool>(grid.zones.size(), false), {}});
    for (const auto zone : zones_in(grid, stated.where(), path)) place.zones[zone] = true;
    for (const FreeFieldColumn& column : columns)
      for (std::size_t k = 0; k < column.edges.size(); ++k)
        place.zones[column.zone(k)] = place.zones[column.edges[k].zone];
    if (!stated.where().has_group())
      place.around.emplace(stated.where(), path, tolerance(grid));
    else if (!locator_)
      locator_ = std::make_shared<ZoneLocator>(grid);
  }
}

std::vector<double> WaterAtRest::pressures() const {
  std::vector<double> pressures;
  for (std::size_t z = 0; z < grid_->zones.size(); ++z) {
    const double y = centroid(corners(*grid_, z))[1];
    double pressure = pressure_below(water_->level(), y);
    for (const auto& [stated, zones, around] : places_)
      if (zones[z])
        pressure = stated->has_pressure() ? stated->pressure() : pressure_below(stated->level(), y);
    pressures.push_back(pressure);
  }
  return pressures;
}

double WaterAtRest::pressure_below(double level, double y) const {
  return protocol::pressure_at_rest(*water_, level, y);
}

bool WaterAtRest::holds(const Place& place, double x, double y) const {
  if (place.around) return place.around->hold(x, y);
  const auto found = locator_->locate(x, y);
  return found && place.zones[found->zone];
}

template <class Statement>
std::optional<double> WaterAtRest::last_level(Statement&& statement) const {
  std::optional<double> level;
  for (const Place& place : places_)
    if (place.stated->has_level() && statement(place)) level = place.stated->level();
  return level;
}

double WaterAtRest::level_at(double x, double y, std::optional<std::uint32_t> above) const {
  if (const auto level = last_level([&](const Place& place) { return holds(place, x, y); })) return *level;
  if (above)
    if (const auto level = last_level([&](const Place& place) { return place.zones[*above]; })) return *level;
  return water_->level();
}

std::vector<bool> WaterAtRest::used() const {
  std::vector<bool> used;
  for (const Place& place : places_) used.push_back(std::ranges::count(place.zones, true) > 0);
  return used;
}

}  // namespace adit::fdm
