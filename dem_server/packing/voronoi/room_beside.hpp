// How much room the nuclei beside a face have: how far the next face is that runs beside it.
#pragma once

#include <span>

#include "dem_server/packing/voronoi/cell_points.hpp"

namespace adit::dem {

class RoomBeside {
 public:
  explicit RoomBeside(const CellPacking& wanted);

  // Distance [m] along the normal, to either side, from a point of the face with this number to the nearest
  // piece of a face whose normal is within 25 degrees of this one, or 45 degrees on the same face; twice that
  // to a side of the box, which needs no nuclei beside it. Infinite where there is none. What is nearer than
  // size / 4 on the same face is the face itself. Throws std::invalid_argument where another face is nearer
  // than about size / 2 although the two meet nowhere: then not both can be edges of cells of this size.
  double at(const geometry::Point& point, const geometry::Point& normal, std::size_t face) const;

 private:
  struct Piece {
    geometry::Point from, to;
    std::size_t face;
  };
  struct Circle {
    FaceCircle circle;
    std::size_t face;
  };
  void refuse_close(std::size_t face, std::size_t other, double size) const;

  std::vector<CellFace> faces_;
  std::vector<Piece> pieces_, sides_;
  std::vector<Circle> circles_;
  CellSize size_;
};

}  // namespace adit::dem
