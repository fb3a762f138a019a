// Faces as paths that hang together at vertices.
#pragma once

#include <vector>

#include "dem_server/packing/voronoi/face_route.hpp"

namespace adit::dem {

// A path of a face that begins or ends at a vertex.
struct Ray {
  std::size_t face, path;
  bool begins;
};

// A junction of faces, or a sharp corner of one.
struct Vertex {
  geometry::Point point;
  std::vector<Ray> rays;  // counter-clockwise; at least two
};

struct FaceNetwork {
  std::vector<Route> routes;  // of each face
  std::vector<Vertex> vertices;
};

FaceNetwork connect_faces(const std::vector<CellFace>& faces, const CellSize& size);

// The angles of a vertex's sectors, given the direction of each ray, counter-clockwise [rad].
std::vector<double> sectors_between(const std::vector<geometry::Point>& directions);

}  // namespace adit::dem
