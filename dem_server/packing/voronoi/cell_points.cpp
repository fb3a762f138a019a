#include "dem_server/packing/voronoi/cell_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dem_server/packing/voronoi/cover_faces.hpp"
#include "dem_server/packing/voronoi/face_nuclei.hpp"
#include "dem_server/packing/voronoi/fill.hpp"
#include "dem_server/packing/voronoi/junctions.hpp"
#include "dem_server/packing/voronoi/margin.hpp"
#include "protocol/geometry/polygon.hpp"
#include "protocol/motion/random.hpp"

namespace adit::dem {
namespace {

bool is_finite(const geometry::Point& p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

bool is_proper(const CellFace& face, const CellSize& size) {
  if (const auto* line = std::get_if<FaceLine>(&face))
    return std::ranges::all_of(line->corners, is_finite) && line->corners.size() >= 2 &&
           (line->closed ? geometry::is_simple(line->corners) : geometry::is_simple_line(line->corners));
  const auto& [centre, radius] = std::get<FaceCircle>(face);
  return is_finite(centre) && std::isfinite(radius) && radius >= kSmallestCircle * size.at(centre);
}

void check(const CellPacking& wanted) {
  const double width = wanted.box.x_max - wanted.box.x_min, height = wanted.box.y_max - wanted.box.y_min;
  for (const double size : {wanted.size.least(), wanted.size.largest()})
    if (!(size > 0) || !std::isfinite(size))
      throw std::invalid_argument(fmt::format("the size of cells is {}, not positive", size));
  if (!(width > 0 && height > 0) || !std::isfinite(width * height))
    throw std::invalid_argument("the box of a packing of cells has no finite area");
  for (std::size_t k = 0; k < wanted.faces.size(); ++k)
    if (!is_proper(wanted.faces[k], wanted.size))
      throw std::invalid_argument(fmt::format(
          "face {} of a packing of cells is neither a line that does not meet itself nor a circle with a "
          "radius of at least {} m, half the size of a cell",
          k, kSmallestCircle * wanted.size.largest()));
}

}  // namespace

std::vector<geometry::Point> pack_cells(const CellPacking& wanted) {
  check(wanted);
  motion::Random random(wanted.seed);
  CellPacking met = wanted;
  met.faces = with_ends_on_faces(wanted.faces, wanted.size);
  const auto covers = cover_faces(met.faces, wanted.size, RoomBeside(met), random);
  PointGrid nuclei(wanted.box, std::sqrt(wanted.size.least() * wanted.size.largest()));
  const Margin margin(wanted);
  const auto discs = add_face_nuclei(covers, margin, nuclei);
  fill(margin, wanted.size, discs, random, nuclei);
  return nuclei.points();
}

}  // namespace adit::dem
