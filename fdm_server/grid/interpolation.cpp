#include "fdm_server/grid/interpolation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fdm_server/grid/locate.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

bool in_some(std::span<const Corners> zones, double x, double y) {
  constexpr double kEdge = 1 + 1e-9;
  return std::ranges::any_of(zones, [&](const Corners& zone) {
    const auto natural = inverse_bilinear(zone, x, y);
    return natural && std::abs((*natural)[0]) <= kEdge && std::abs((*natural)[1]) <= kEdge;
  });
}

}  // namespace

std::vector<protocol::OperatorRow> interpolate(const Grid& grid, std::span<const double> places,
                                               std::span<const Corners> slivers) {
  const ZoneLocator locator(grid);
  std::vector<protocol::OperatorRow> rows;
  rows.reserve(places.size() / 2);
  for (std::size_t k = 0; k + 1 < places.size(); k += 2) {
    auto place = locator.locate(places[k], places[k + 1]);
    if (!place && in_some(slivers, places[k], places[k + 1]))
      place = locator.beyond(places[k], places[k + 1]);
    if (!place)
      throw protocol::UserError("interface.overlap",
                                fmt::format("holds the coupling point ({}, {}) m, which lies outside the "
                                            "continuum; let the continuum cover the overlap",
                                            places[k], places[k + 1]));
    protocol::OperatorRow& row = rows.emplace_back();
    std::ranges::copy(grid.zones[place->zone], row.points.begin());
    row.shares = place->shape;
  }
  return rows;
}

}  // namespace adit::fdm
