// Covers a face by discs of irregular spacing.
#pragma once

#include "dem_server/packing/voronoi/cover_discs.hpp"
#include "dem_server/packing/voronoi/room_beside.hpp"
#include "protocol/motion/random.hpp"

namespace adit::dem {

// Discs about 0.87 size apart, whose edges cut each other about size / 2 beside the face; less in both where
// the room is less than 2 size. A line has a disc at each of its ends and at each corner where it turns by
// more than 30 degrees; the discs on both sides of such a corner cut its disc in one point, on the bisector,
// where the one nucleus beside both sides lies. At other corners there is a disc unless they are within
// 0.8 size of the last disc at a corner. A circle's discs lie on the circle with the same area as the polygon
// of their centres.
FaceCover cover_face(const CellFace& face, std::size_t number, double size, const RoomBeside& room,
                     motion::Random& random);

}  // namespace adit::dem
