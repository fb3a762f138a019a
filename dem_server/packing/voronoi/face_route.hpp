// Faces as paths from corner to corner.
#pragma once

#include <vector>

#include "dem_server/packing/voronoi/face_path.hpp"
#include "dem_server/packing/voronoi/junctions.hpp"

namespace adit::dem {

struct RouteCorner {
  geometry::Point point;
  bool sharp;  // the face turns here by more than 30 degrees
  bool at_junction;
};

// Path k leads from corner k to corner k + 1. A circle without junctions has neither corners nor paths.
struct Route {
  std::vector<RouteCorner> corners;
  std::vector<Path> paths;
  bool closed;  // the last corner is the first
};

// The route along a face with a corner at each of these points of it, its junctions, at each end, at each
// sharp corner, and at other corners unless they are within 0.8 size of the last one or the next one.
Route route_along(const CellFace& face, const std::vector<geometry::Point>& junctions, const CellSize& size);

}  // namespace adit::dem
