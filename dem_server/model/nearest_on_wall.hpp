// Where a wall is nearest to a disc.
#pragma once

#include <algorithm>

#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {

// Places count from the wall's first end, wherever the wall has moved.
// How far along the wall a point lies, from 0 at its first to 1 at its second end; less or more beyond them.
inline double along_wall(const MovingWall& wall, double x, double y) {
  const double along_x = wall.x_2 - wall.x_1, along_y = wall.y_2 - wall.y_1;
  return (x * along_x + y * along_y) / (along_x * along_x + along_y * along_y);
}

inline bool is_beside_wall(const MovingWall& wall, double x, double y) {
  const double share = along_wall(wall, x, y);
  return share > 0 && share < 1;
}

// From a point to the nearest point of a wall, both ends included [m].
inline PlaneVector to_wall(const MovingWall& wall, double x, double y) {
  const double share = std::clamp(along_wall(wall, x, y), 0.0, 1.0);
  return {share * (wall.x_2 - wall.x_1) - x, share * (wall.y_2 - wall.y_1) - y};
}

}  // namespace adit::dem
