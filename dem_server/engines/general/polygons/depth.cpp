#include "dem_server/engines/general/polygons/depth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace adit::dem {
namespace {

// The distance to one side along the way, which is from 0 at its begin to 1 at its end.
struct Side {
  double nx, ny;
  double at_begin, growth;
  double at(double share) const { return at_begin + share * growth; }
};

void find_sides(const geometry::Point& a, const geometry::Point& b, std::span<const geometry::Point> corners,
                std::vector<Side>& sides) {
  sides.clear();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto &one = corners[k], &other = corners[k + 1 < corners.size() ? k + 1 : 0];
    const double length = std::hypot(other.x - one.x, other.y - one.y);
    if (length == 0) continue;
    const double nx = (other.y - one.y) / length, ny = -(other.x - one.x) / length;
    sides.push_back(
        {nx, ny, (one.x - a.x) * nx + (one.y - a.y) * ny, -((b.x - a.x) * nx + (b.y - a.y) * ny)});
  }
}

struct Piece {
  double begin, end;
  const Side* nearest;
};

// The pieces of the way on which all sides are farther than `free`, with the nearest side of each.
template <class See>
void for_each_piece(const std::vector<Side>& sides, double free, const See& see) {
  double begin = 0, end = 1;
  for (const Side& side : sides) {
    const double there = side.at_begin - free;
    if (side.growth == 0) {
      if (there <= 0) return;
      continue;
    }
    const double crossing = -there / side.growth;
    (side.growth > 0 ? begin : end) = side.growth > 0 ? std::max(begin, crossing) : std::min(end, crossing);
  }
  const Side* nearest = nullptr;
  for (double share = begin; share < end;) {
    if (!nearest)
      nearest = &*std::ranges::min_element(sides, [share](const Side& one, const Side& other) {
        const double d = one.at(share), e = other.at(share);
        return d < e || (d == e && one.growth < other.growth);
      });
    const Side* next = nullptr;
    double until = end;
    for (const Side& side : sides) {
      if (!(side.growth < nearest->growth)) continue;
      const double meets = (side.at_begin - nearest->at_begin) / (nearest->growth - side.growth);
      if (meets >= until) continue;
      until = std::max(meets, share);  // where several are as near, by rounding another one came first
      next = &side;
    }
    if (until > share) see(Piece{share, until, nearest});
    share = until;
    if (next) nearest = next;
  }
}

}  // namespace

Depth depth_of(const geometry::Point& a, const geometry::Point& b, std::span<const geometry::Point> corners,
               double free) {
  thread_local std::vector<Side> sides;
  find_sides(a, b, corners, sides);
  const double along_x = b.x - a.x, along_y = b.y - a.y, length = std::hypot(along_x, along_y);
  Depth sum;
  double gx = 0, gy = 0, area = 0, middle = 0, turning = 0;
  for_each_piece(sides, free, [&](const Piece& piece) {
    const Side& side = *piece.nearest;
    const double d = side.at(piece.begin) - free, e = side.at(piece.end) - free,
                 way = length * (piece.end - piece.begin);
    if (!(d + e > 0)) return;  // along a side
    const double depth = way * (d + e) / 2;
    // The place in the piece about which d balances.
    const double share = piece.begin + (piece.end - piece.begin) * (d + 2 * e) / (3 * (d + e));
    sum.stored += way * (d * d + d * e + e * e) / 6;
    gx += depth * side.nx;
    gy += depth * side.ny;
    area += depth;
    middle += depth * share;
    turning += depth * ((a.x + share * along_x) * side.ny - (a.y + share * along_y) * side.nx);
  });
  sum.pushing = std::hypot(gx, gy);
  if (!(sum.stored > 0) || sum.pushing == 0) return {};
  sum.nx = gx / sum.pushing;
  sum.ny = gy / sum.pushing;
  const double x = a.x + middle / area * along_x, y = a.y + middle / area * along_y;
  const double off = x * sum.ny - y * sum.nx - turning / sum.pushing;
  sum.x = x - off * sum.ny;
  sum.y = y + off * sum.nx;
  return sum;
}

double largest_depth(const geometry::Point& a, const geometry::Point& b,
                     std::span<const geometry::Point> corners) {
  thread_local std::vector<Side> sides;
  find_sides(a, b, corners, sides);
  double largest = 0;
  for_each_piece(sides, 0, [&](const Piece& piece) {
    largest = std::max({largest, piece.nearest->at(piece.begin), piece.nearest->at(piece.end)});
  });
  return largest;
}

}  // namespace adit::dem
