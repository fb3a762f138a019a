#include "dem_server/engines/general/polygons/cell_polygons.hpp"

#include <algorithm>
#include <cmath>

#include "dem_server/model/model.hpp"

namespace adit::dem {
namespace {

constexpr double kSideOfArea =
    0.62040323844;  // of a regular hexagon, over the root of its area: (2 / 3^1.5)^0.5

double perimeter_of(const CellOutline& outline) {
  double sum = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const auto &a = outline[k], &b = outline[k + 1 < outline.size() ? k + 1 : 0];
    sum += std::hypot(b.x - a.x, b.y - a.y);
  }
  return sum;
}

}  // namespace

CellPolygons::CellPolygons(const Model& model) : outlines(model.outlines) {
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    double farthest = 0;
    for (const geometry::Point& corner : outlines[i])
      farthest = std::max(farthest, std::hypot(corner.x, corner.y));
    reach.push_back(farthest);
    perimeter.push_back(perimeter_of(outlines[i]));
    side.push_back(kSideOfArea * std::sqrt(model.cell_area(i)));
  }
}

void CellPolygons::place(std::uint32_t cell, const PlaneVector& nucleus, const FacetSet& facets,
                         std::vector<geometry::Point>& corners) const {
  corners.clear();
  for (const geometry::Point& corner : outlines[cell]) {
    const PlaneVector turned = vector_of(1 - facets.versine[cell], facets.sine[cell], corner.x, corner.y);
    corners.push_back({nucleus.x + turned.x, nucleus.y + turned.y});
  }
}

}  // namespace adit::dem
