#include "fdm_server/water/faces.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cstddef>

#include "fdm_server/grid/edges.hpp"

namespace adit::fdm {
namespace {

using Eigen::Vector2d;

// Of the distance between two centres: a shift along the side that is rounding, not shape.
constexpr double kStraight = 1e-9;

struct ZoneSide {
  std::uint32_t zone, side;
};

class PairSet {
 public:
  explicit PairSet(std::span<const PointPair> pairs) {
    for (const auto& [a, b] : pairs) pairs_.push_back(in_order(a, b));
    std::ranges::sort(pairs_);
  }
  bool holds(const Edge& edge) const {
    return std::ranges::binary_search(pairs_, in_order(edge.from, edge.to));
  }

 private:
  static PointPair in_order(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

  std::vector<PointPair> pairs_;
};

// The zones with mobility beside each edge, at most two.
std::vector<std::vector<ZoneSide>> zones_beside(const Edges& edges, const Mobility& mobility) {
  std::vector<std::vector<ZoneSide>> beside(edges.list.size());
  for (std::uint32_t z = 0; z < edges.of_zone.size(); ++z)
    for (std::uint32_t c = 0; c < 4; ++c)
      if (mobility.x[z] > 0) beside[edges.of_zone[z][c]].push_back({z, c});
  return beside;
}

// What a zone brings to one of its sides.
struct Half {
  Vector2d conormal;        // w
  double transmissibility;  // alpha
};

class Shapes {
 public:
  Shapes(const Grid& grid, const Mobility& mobility) : grid_(grid), mobility_(mobility) {}

  Vector2d centre(std::uint32_t zone) const {
    const auto [x, y] = centroid(corners(grid_, zone));
    return {x, y};
  }

  // Of the zone itself, or of the one `beyond` the side, with the normal that leaves the first.
  Half half(const ZoneSide& side) const { return half(side, side.zone, 1); }
  Half half_beyond(const ZoneSide& side, std::uint32_t beyond) const { return half(side, beyond, -1); }

 private:
  Half half(const ZoneSide& side, std::uint32_t zone, double sign) const {
    const Corners at = corners(grid_, side.zone);
    const std::size_t from = side.side, to = (side.side + 1) % 4;
    const Vector2d start(at.x[from], at.y[from]), normal(at.y[to] - at.y[from], at.x[from] - at.x[to]);
    const Vector2d conormal(mobility_.x[zone] * normal.x(), mobility_.y[zone] * normal.y());
    return {conormal, normal.dot(conormal) / (sign * normal.dot(start - centre(zone)))};
  }

  const Grid& grid_;
  const Mobility& mobility_;
};

// T and s of the side between two zones, as the first sees it.
struct Joint {
  double transmissibility;
  Vector2d rest;
};

Joint joint(const Shapes& shapes, const ZoneSide& a, std::uint32_t b) {
  const Half near = shapes.half(a), far = shapes.half_beyond(a, b);
  const double t = 1 / (1 / near.transmissibility + 1 / far.transmissibility);
  const Vector2d between = shapes.centre(b) - shapes.centre(a.zone);
  const Vector2d shift =
      near.conormal / near.transmissibility + far.conormal / far.transmissibility - between;
  return {t, shift.norm() > kStraight * between.norm() ? Vector2d(t * shift) : Vector2d::Zero()};
}

using Rests = std::array<Vector2d, 4>;  // s of each side

SkewedZone skewed_zone(const Shapes& shapes, std::uint32_t zone, const WaterPassages& passages,
                       const Rests& rests) {
  SkewedZone result{zone, {}, {}};
  Eigen::Matrix2d normal_equations = Eigen::Matrix2d::Zero();
  for (std::uint32_t c = 0; c < 4; ++c) {
    const Half half = shapes.half({zone, c});
    const Vector2d way = (half.conormal - rests[c]) / half.transmissibility;
    normal_equations += way.normalized() * way.normalized().transpose();
    result.slope[c] = passages[c].transmissibility / half.transmissibility / way.squaredNorm() * way;
    result.cross[c] = rests[c] / 2;
  }
  for (Vector2d& slope : result.slope) slope = normal_equations.inverse() * slope;
  return result;
}

}  // namespace

Faces make_faces(const Grid& grid, const Mobility& mobility, std::span<const PointPair> open,
                 std::span<const PointPair> sealed) {
  const Shapes shapes(grid, mobility);
  const PairSet opened(open), closed(sealed);
  const Edges edges = number_edges(grid);
  const auto beside = zones_beside(edges, mobility);
  Faces faces;
  faces.of_zone.resize(grid.zones.size());
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z) faces.of_zone[z].fill({0, z});
  std::vector<Rests> rests(grid.zones.size(),
                           Rests{Vector2d::Zero(), Vector2d::Zero(), Vector2d::Zero(), Vector2d::Zero()});
  std::vector<bool> is_skewed(grid.zones.size());

  for (std::size_t e = 0; e < beside.size(); ++e) {
    if (beside[e].empty() || closed.holds(edges.list[e])) continue;
    const ZoneSide a = beside[e].front(), b = beside[e].back();
    // Both sides of a column of one zone's width are the same edge, and lead nowhere.
    if (beside[e].size() == 2 && a.zone != b.zone) {
      const Joint between = joint(shapes, a, b.zone);
      faces.of_zone[a.zone][a.side] = {between.transmissibility, b.zone};
      faces.of_zone[b.zone][b.side] = {between.transmissibility, a.zone};
      rests[a.zone][a.side] = between.rest;
      rests[b.zone][b.side] = -between.rest;
      if (!between.rest.isZero(0)) is_skewed[a.zone] = is_skewed[b.zone] = true;
    } else if (beside[e].size() == 1 && opened.holds(edges.list[e])) {
      faces.of_zone[a.zone][a.side] = {shapes.half(a).transmissibility, kOpenSide};
    }
  }
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z)
    if (is_skewed[z]) faces.skewed.push_back(skewed_zone(shapes, z, faces.of_zone[z], rests[z]));
  return faces;
}

}  // namespace adit::fdm
