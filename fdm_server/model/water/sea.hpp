// Water that stands on the ground: its sides that look upwards or sidewards, that a vertical line leads up
// from into the sky, and that lie below the level there, which is that of the ground straight below: walls of
// a pit have the level of its floor. Places with ground above them are dry, also where they are open at a
// side. Vertical sides at the left and right end of the model go on as ground.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fdm_server/boundaries/free_field.hpp"
#include "fdm_server/grid/grid.hpp"
#include "fdm_server/model/water/at_rest.hpp"
#include "fdm_server/solver/loads.hpp"

namespace adit::fdm {

// Of each zone: what this model has of the energy in the middles of its sides, from its point c to c + 1; the
// rest is another model's, by their overlap. Empty: all.
using SideShares = std::vector<std::array<double, 4>>;

// A side that is below water at least in part, its zone on its left, and the level of the water [m].
struct WetSide {
  std::array<std::uint32_t, 2> points;
  double level;
  bool whole;  // below it
};

// `weights`: of the zones; 0 where they were taken away. Sides without a share are the other model's.
// UserError for a side that both have a share of, since particles bear no water.
std::vector<WetSide> sides_under_sea(const WaterAtRest& water, const Grid& grid,
                                     std::span<const double> weights, const SideShares& shares);

// The pressure on them, and on the columns.
Load weight_of_sea(const WaterAtRest& water, const Grid& grid, std::span<const double> weights,
                   const SideShares& shares, std::span<const FreeFieldColumn> columns);

// The level on the top of a column.
double level_on(const WaterAtRest& water, const Grid& grid, const FreeFieldColumn& column);
// Whether a height is not above a level, but for rounding.
bool is_below(double y, double level, const Grid& grid);

}  // namespace adit::fdm
