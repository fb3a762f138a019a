// Where the nuclei of irregular cells lie, so that given lines are edges of cells: the cells of such a
// packing (voronoi_cells.hpp) end exactly at the faces of a lining or at the bounds of a layer.
//
// Faces are covered by overlapping discs centred on them, and the nuclei beside a face are the two points
// where consecutive discs cut each other (Abdelkader et al. 2020, ACM Trans. Graph. 39, 23, "VoroCrust",
// sections 3 and 4, here in two dimensions). The two are mirror images about the chord between the discs'
// centres; if no disc holds a nucleus, their facet is this chord and the centres are corners of cells. What
// is left is filled by maximal Poisson-disc sampling (Ebeida et al. 2012, Comput. Graph. Forum 31, 785):
// nuclei drawn at random with a least distance until there is room for none. Irregular cells have no planes
// along which they could slide or crack more easily. Where sizes differ, all distances are those of the
// place.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "dem_server/packing/voronoi/cell_size.hpp"
#include "protocol/geometry/bounding_box.hpp"
#include "protocol/geometry/shape.hpp"

namespace adit::dem {

// A line at which cells end.
struct FaceLine {
  std::vector<geometry::Point> corners;  // at least two, none the same as the next one
  bool closed = false;                   // the last is joined with the first
};
inline constexpr double kSmallestCircle = 0.5;  // its radius over the packing's size
struct FaceCircle {
  geometry::Point centre;
  double radius;  // [m]
};
using CellFace = std::variant<FaceLine, FaceCircle>;

struct CellPacking {
  geometry::BoundingBox box;
  CellSize size;
  std::vector<CellFace> faces;
  std::uint64_t seed = 1;
};

// Nuclei in the box: first those beside the faces, in the faces' order, then the others. They are at least
// size / 4 from the sides of the box, which need no nuclei beside them. The same packing gives the same
// nuclei on every machine.
//
// Lines are exact, corners of 40 degrees and more included; where a line bends by less than 30 degrees within
// 0.8 size of a corner, it is rounded off by chords, which start and end on the line. A circle becomes a
// polygon of the same area. Faces that run beside each other, or beside a side of the box, are exact down to
// a distance of size / 2: from 2 size down the nuclei move closer to them, and from 1.3 size down also to
// each other.
//
// Faces that cross or meet at 35 degrees or more are all exact there: the point is a corner of cells, from
// which a facet leaves along each of them (junctions.hpp, vertex_angles.hpp). The open end of a line moves
// onto such a face if it is less than size beyond it, or less than size / 4 short of it. Two junctions, or a
// junction and a sharp corner, need 1.2 size between them. Elsewhere the face that is named first is exact,
// and cells deviate from the other by up to 1.5 size; from both where they meet at less than 26 degrees. From
// all faces they deviate as much where these reach the sides of the box. A piece that faces share is exact.
//
// Throws std::invalid_argument where the size is not positive, the box has no area, a face is not as stated
// above or meets itself, or two faces are closer than about size / 2 beside each other but meet nowhere.
std::vector<geometry::Point> pack_cells(const CellPacking& wanted);

}  // namespace adit::dem
