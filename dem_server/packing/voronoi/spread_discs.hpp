// How far apart the discs along a face are, and how far the nuclei beside it.
#pragma once

#include <vector>

#include "dem_server/packing/voronoi/face_path.hpp"
#include "dem_server/packing/voronoi/room_beside.hpp"
#include "protocol/motion/random.hpp"

namespace adit::dem {

// Where the discs along a path are to be spread.
struct DiscSpan {
  double from, to;     // [m]
  double first, last;  // spacings from `from` to the first disc, and from the last one to `to`
  bool first_fixed = false, last_fixed = false;  // not moved at random
  std::size_t fewest = 0;
};

class DiscSpacing {
 public:
  DiscSpacing(std::size_t face, const CellSize& size, const RoomBeside& room)
      : face_(face), size_(size), room_(room) {}

  // Of the nuclei from the face: at most half the size, less where there is little room [m].
  double most_offset(const geometry::Point& point) const { return size_.at(point) / 2; }
  double offset(const Path::Place& place) const;
  // Of the discs there [m].
  double spacing(const Path::Place& place) const { return spacing(place, offset(place)); }

  // Places along the path in the span, a spacing apart, each moved at random unless it is fixed.
  std::vector<double> spread(const Path& path, const DiscSpan& span, motion::Random& random) const;

 private:
  double spacing(const Path::Place& place, double offset) const;

  std::size_t face_;
  const CellSize& size_;
  const RoomBeside& room_;
};

}  // namespace adit::dem
