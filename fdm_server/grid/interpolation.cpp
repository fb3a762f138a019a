#include "fdm_server/grid/interpolation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fdm_server/grid/locate.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {

std::vector<protocol::OperatorRow> interpolate(const Grid& grid, std::span<const double> places) {
  const ZoneLocator locator(grid);
  std::vector<protocol::OperatorRow> rows;
  rows.reserve(places.size() / 2);
  for (std::size_t k = 0; k + 1 < places.size(); k += 2) {
    const auto place = locator.locate(places[k], places[k + 1]);
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
