// Finding the zone that holds a point, and the point's place in it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "protocol/geometry/cells.hpp"

namespace adit::fdm {

// Bilinear shape functions at a point of a zone: sum 1; non-negative in the zone.
struct Place {
  std::uint32_t zone;
  std::array<double, 4> shape;
};

// The point's natural coordinates in the quadrilateral (xi, eta in [-1, 1] inside), by Newton's method on the
// bilinear map; no value where it does not converge, which for convex zones means far outside.
std::optional<std::array<double, 2>> inverse_bilinear(const Corners& corners, double x, double y);

// Finds zones by cells of about one zone each.
class ZoneLocator {
 public:
  explicit ZoneLocator(const Grid& grid);
  // The zone that holds (x, y), within 1e-9 of its size; the first of several (points on an edge). Not one
  // that is hidden: one flag a zone, or none at all.
  std::optional<Place> locate(double x, double y, const std::vector<bool>& hidden = {}) const;
  // The zone nearest to a point outside all, in natural coordinates, and its shape functions there; no value
  // farther than a zone's width from it. Looks at every zone.
  std::optional<Place> beyond(double x, double y) const;

 private:
  const Grid& grid_;
  protocol::Cells cells_;
};

}  // namespace adit::fdm
