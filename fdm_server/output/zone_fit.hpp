// Fields that are known as means over zones, such as stress, at any place.
//
// The mean of a field over a zone is its value at the zone's centroid c_0 but for terms of second order. From
// there it is continued to the place p by a slope g that fits the means s_z of the zones around (those that
// share a point with it) in the sense of least squares:
//   s(p) = s_0 + (p - c_0) . g,   minimize sum over z of (s_0 + (c_z - c_0) . g - s_z)^2,
// so that s(p) is of second order everywhere, at the boundary too, and is the zone's own mean at its
// centroid. In directions in which no zone lies beside it, the slope is 0. Stress and strain jump where the
// ground changes: only zones of the same kind take part.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

// A value as a sum of shares of the zones' values; the shares sum to 1.
struct ZoneShares {
  std::vector<std::uint32_t> zones;
  std::vector<double> shares;
};

// The kind of a zone that holds no ground.
inline constexpr std::uint32_t kNoGround = std::numeric_limits<std::uint32_t>::max();

// The value at (x, y) [m] in `zone`; `kinds`: one a zone, such as its material.
ZoneShares fit_around(const Grid& grid, std::span<const std::uint32_t> kinds, std::uint32_t zone, double x,
                      double y);

}  // namespace adit::fdm
