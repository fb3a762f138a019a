// Where a wall is nearest to a disc.
#pragma once

#include <algorithm>

#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {

// From a point to the nearest point of a wall, both ends included [m]; x and y count from the wall's first
// end, wherever the wall has moved.
inline PlaneVector to_wall(const MovingWall& wall, double x, double y) {
  const double along_x = wall.x_2 - wall.x_1, along_y = wall.y_2 - wall.y_1;
  const double squared = along_x * along_x + along_y * along_y;
  const double share = std::clamp((x * along_x + y * along_y) / squared, 0.0, 1.0);
  return {share * along_x - x, share * along_y - y};
}

}  // namespace adit::dem
