#include "dem_server/packing/voronoi/cell_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dem_server/packing/voronoi/cover_faces.hpp"
#include "dem_server/packing/voronoi/face_nuclei.hpp"
#include "dem_server/packing/voronoi/fill.hpp"
#include "dem_server/packing/voronoi/junctions.hpp"
#include "protocol/geometry/polygon.hpp"
#include "protocol/motion/random.hpp"

namespace adit::dem {
namespace {

// Shares of the size. The least distance gives cells with the mean area of hexagonal ones.
constexpr double kLeastDistance = 0.777, kFromSides = 0.25;

bool is_finite(const geometry::Point& p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

bool is_proper(const CellFace& face, double size) {
  if (const auto* line = std::get_if<FaceLine>(&face))
    return std::ranges::all_of(line->corners, is_finite) && line->corners.size() >= 2 &&
           (line->closed ? geometry::is_simple(line->corners) : geometry::is_simple_line(line->corners));
  const auto& [centre, radius] = std::get<FaceCircle>(face);
  return is_finite(centre) && std::isfinite(radius) && radius >= kSmallestCircle * size;
}

void check(const CellPacking& wanted) {
  const double width = wanted.box.x_max - wanted.box.x_min, height = wanted.box.y_max - wanted.box.y_min;
  if (!(wanted.size > 0) || !std::isfinite(wanted.size))
    throw std::invalid_argument(fmt::format("the size of cells is {}, not positive", wanted.size));
  if (!(width > 0 && height > 0) || !std::isfinite(width * height))
    throw std::invalid_argument("the box of a packing of cells has no finite area");
  for (std::size_t k = 0; k < wanted.faces.size(); ++k)
    if (!is_proper(wanted.faces[k], wanted.size))
      throw std::invalid_argument(fmt::format(
          "face {} of a packing of cells is neither a line that does not meet itself nor a circle with a "
          "radius of at least {} m, half the size of a cell",
          k, kSmallestCircle * wanted.size));
}

// The box without a strip along its sides, in which no nucleus lies; of a small box, half of it.
geometry::BoundingBox inside_of(const CellPacking& wanted) {
  const auto& box = wanted.box;
  const double across = std::min(kFromSides * wanted.size, (box.x_max - box.x_min) / 4);
  const double up = std::min(kFromSides * wanted.size, (box.y_max - box.y_min) / 4);
  return {box.x_min + across, box.x_max - across, box.y_min + up, box.y_max - up};
}

}  // namespace

std::vector<geometry::Point> pack_cells(const CellPacking& wanted) {
  check(wanted);
  motion::Random random(wanted.seed);
  CellPacking met = wanted;
  met.faces = with_ends_on_faces(wanted.faces, wanted.size);
  const auto covers = cover_faces(met.faces, wanted.size, RoomBeside(met), random);
  PointGrid nuclei(wanted.box, wanted.size);
  const auto discs = add_face_nuclei(covers, inside_of(wanted), nuclei);
  fill(inside_of(wanted), kLeastDistance * wanted.size, discs, random, nuclei);
  return nuclei.points();
}

}  // namespace adit::dem
