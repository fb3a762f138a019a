// Covers faces by discs of irregular spacing.
#pragma once

#include "dem_server/packing/voronoi/cover_discs.hpp"
#include "dem_server/packing/voronoi/room_beside.hpp"
#include "protocol/motion/random.hpp"

namespace adit::dem {

// Covers for each face in turn, none where an earlier face has the same piece: discs about 0.87 size apart,
// whose edges cut each other about size / 2 beside the face; less in both where the room is less than 2 size.
// A line has a disc at each of its ends and at corners (face_route.hpp). A circle's discs lie on the circle
// with the same area as the polygon of their centres, but for those at its junctions.
//
// Vertices are the junctions and the corners where a line turns by more than 30 degrees. A vertex has one
// disc for all its faces, and the next discs along each of them pass through the two nuclei on the vertex's
// disc that belong to this ray (vertex_angles.hpp).
std::vector<FaceCover> cover_faces(const std::vector<CellFace>& faces, const CellSize& size,
                                   const RoomBeside& room, motion::Random& random);

}  // namespace adit::dem
