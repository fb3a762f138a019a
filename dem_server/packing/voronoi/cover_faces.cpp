#include "dem_server/packing/voronoi/cover_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "dem_server/packing/voronoi/face_network.hpp"
#include "dem_server/packing/voronoi/spread_discs.hpp"
#include "dem_server/packing/voronoi/vertex_angles.hpp"

namespace adit::dem {
namespace {

using geometry::Point;

// Shares of the size.
constexpr double kLeastRadius = 0.7, kMostRadius = 1.2;  // of the disc at a vertex
constexpr double kBetweenNuclei = 0.7;                   // on this disc, within these bounds
constexpr double kStep = 0.125;                          // after which a ray's direction is taken
constexpr double kLeastOfPath = 3;  // length of a path over the foot of the pair of nuclei at its end
constexpr std::size_t kFewestAround = 5;

// What a path has at one of its ends: the pair of nuclei of a vertex, or nothing.
struct PathEnd {
  bool at_vertex = false;
  double foot = 0, offset = 0;  // of the pair: along the path from the end, and from the path [m]
};

struct CoveredPath {
  PathEnd begin, end;
  std::size_t first = 0, last = 0;  // numbers of the discs at its ends
};

class Covering {
 public:
  Covering(const std::vector<CellFace>& faces, const CellSize& size, const RoomBeside& room);

  // In this order.
  void size_vertices();
  void place_discs(std::size_t face, motion::Random& random);
  void choose_radii(std::size_t face);
  void fit_to_vertices();

  // The covers of the faces, without the paths that an earlier face covers.
  std::vector<FaceCover> take_covers();

 private:
  const Path& path_of(const Ray& ray) const { return network_.routes[ray.face].paths[ray.path]; }
  PathEnd& end_of(const Ray& ray) {
    CoveredPath& covered = covered_[ray.face][ray.path];
    return ray.begins ? covered.begin : covered.end;
  }
  CoverDisc& disc_at_vertex(const Ray& ray);
  CoverDisc& next_disc(const Ray& ray);

  void set_pairs(const Vertex& vertex, double radius, const std::vector<double>& beside);
  std::vector<double> between(std::size_t face, std::size_t path, motion::Random& random) const;
  void add(std::size_t face, const Path::Place& place);
  void place_around(const FaceCircle& circle, std::size_t face, motion::Random& random);
  void give_area(const FaceCircle& circle, std::size_t face);
  void fit_lone_discs();
  bool is_shared(std::size_t face, std::size_t path) const;

  const std::vector<CellFace>& faces_;
  const CellSize& size_;
  FaceNetwork network_;
  std::vector<double> radii_;                      // of the vertices' discs [m]
  std::vector<std::vector<bool>> with_one_;        // the sectors of each vertex that have one nucleus
  std::vector<std::vector<CoveredPath>> covered_;  // the paths of each face
  std::vector<std::vector<double>> offsets_;       // that the nuclei near each disc should have [m]
  std::vector<DiscSpacing> spacings_;              // of each face
  std::vector<FaceCover> covers_;                  // of each face
};

Covering::Covering(const std::vector<CellFace>& faces, const CellSize& size, const RoomBeside& room)
    : faces_(faces),
      size_(size),
      network_(connect_faces(faces, size)),
      covered_(faces.size()),
      offsets_(faces.size()),
      covers_(faces.size()) {
  for (std::size_t face = 0; face < faces.size(); ++face) {
    covered_[face].resize(network_.routes[face].paths.size());
    spacings_.emplace_back(face, size, room);
  }
}

void Covering::set_pairs(const Vertex& vertex, double radius, const std::vector<double>& beside) {
  for (std::size_t k = 0; k < vertex.rays.size(); ++k)
    end_of(vertex.rays[k]) = {true, radius * std::cos(beside[k]), radius * std::sin(beside[k])};
}

// Scaled down where there is little room beside the vertex or along its rays.
void Covering::size_vertices() {
  for (const Vertex& vertex : network_.vertices) {
    std::vector<Point> directions;
    const double size = size_.at(vertex.point);
    for (const Ray& ray : vertex.rays) {
      const Path& path = path_of(ray);
      const double step = kStep * size;
      directions.push_back(unit(vertex.point, path.at(ray.begins ? step : path.length - step).point));
    }
    const auto sectors = sectors_between(directions);
    with_one_.push_back(sectors_with_one_nucleus(sectors));
    const auto beside = angles_beside_rays(sectors, with_one_.back());
    const double least = least_between_nuclei(sectors, beside);
    const double full =
        size * std::clamp(kBetweenNuclei / 2 / std::sin(least / 2), kLeastRadius, kMostRadius);
    double share = 1;
    for (std::size_t k = 0; k < vertex.rays.size(); ++k) {
      const Ray& ray = vertex.rays[k];
      const Path& path = path_of(ray);
      const DiscSpacing& spacing = spacings_[ray.face];
      share = std::min(
          {share, spacing.offset(path.at(ray.begins ? 0 : path.length)) / spacing.most_offset(vertex.point),
           path.length / (kLeastOfPath * full * std::cos(beside[k]))});
    }
    radii_.push_back(share * full);
    set_pairs(vertex, radii_.back(), beside);
  }
}

// Beside a vertex, half a spacing follows on its pair of nuclei. On a curve, a ray's direction depends on how
// far its first disc is: the same distance on both sides of a junction lets right angles remain so.
std::vector<double> Covering::between(std::size_t face, std::size_t number, motion::Random& random) const {
  const auto& [begin, end, first, last] = covered_[face][number];
  const Path& path = network_.routes[face].paths[number];
  const DiscSpacing& spacing = spacings_[face];
  const double from = begin.foot, to = path.length - end.foot;
  auto places = spacing.spread(path,
                               {.from = from,
                                .to = to,
                                .first = begin.at_vertex ? 0.5 : 1,
                                .last = end.at_vertex ? 0.5 : 1,
                                .first_fixed = begin.at_vertex,
                                .last_fixed = end.at_vertex,
                                .fewest = begin.at_vertex && end.at_vertex ? (path.straight ? 1u : 2u) : 0u},
                               random);
  if (path.straight || places.size() < 2) return places;
  const double most = (to - from) / (2 * static_cast<double>(places.size()));
  const auto half_spacing = [&](double place) { return std::min(most, spacing.spacing(path.at(place)) / 2); };
  if (begin.at_vertex) places.front() = from + half_spacing(0);
  if (end.at_vertex) places.back() = to - half_spacing(path.length);
  return places;
}

void Covering::add(std::size_t face, const Path::Place& place) {
  covers_[face].discs.push_back({place.point, 0});
  offsets_[face].push_back(spacings_[face].offset(place));
}

void Covering::place_discs(std::size_t face, motion::Random& random) {
  const Route& route = network_.routes[face];
  covers_[face].closed = route.closed;
  const auto* circle = std::get_if<FaceCircle>(&faces_[face]);
  if (route.paths.empty()) place_around(*circle, face, random);
  for (std::size_t k = 0; k < route.paths.size(); ++k) {
    covered_[face][k].first = covers_[face].discs.size();
    add(face, route.paths[k].at(0));
    for (const double place : between(face, k, random)) add(face, route.paths[k].at(place));
    covered_[face][k].last = covers_[face].discs.size();
  }
  if (!route.closed) add(face, route.paths.back().at(route.paths.back().length));
  if (circle != nullptr) give_area(*circle, face);
}

void Covering::place_around(const FaceCircle& circle, std::size_t face, motion::Random& random) {
  const double around = 2 * std::numbers::pi;
  const Path path = path_around(circle, around * random.uniform(), around * circle.radius);
  const DiscSpan span{.from = 0, .to = path.length, .first = 0.5, .last = 0.5, .fewest = kFewestAround};
  for (const double place : spacings_[face].spread(path, span, random)) add(face, path.at(place));
}

// Moves the centres of the discs outwards, but for those at junctions, so that their polygon has the circle's
// area. This is a quadratic equation for the share by which they move.
void Covering::give_area(const FaceCircle& circle, std::size_t face) {
  auto& discs = covers_[face].discs;
  std::vector<bool> moves(discs.size(), true);
  for (const CoveredPath& path : covered_[face]) moves[path.first] = false;
  std::array<double, 3> twice_area{};  // of the triangles with none, one and two corners that move
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const std::size_t next = (k + 1) % discs.size();
    const Point &a = discs[k].centre, &b = discs[next].centre, &o = circle.centre;
    twice_area[moves[k] + moves[next]] += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  const auto [none, one, two] = twice_area;
  const double rest = 2 * std::numbers::pi * circle.radius * circle.radius - none;
  const double scale = (std::sqrt(one * one + 4 * two * rest) - one) / (2 * two);
  for (std::size_t k = 0; k < discs.size(); ++k)
    if (moves[k]) {
      Point& p = discs[k].centre;
      p = {circle.centre.x + scale * (p.x - circle.centre.x),
           circle.centre.y + scale * (p.y - circle.centre.y)};
    }
}

void Covering::choose_radii(std::size_t face) {
  auto& discs = covers_[face].discs;
  const std::size_t count = discs.size();
  for (std::size_t k = 0; k < count; ++k) {
    const bool begins = !covers_[face].closed && k == 0, ends = !covers_[face].closed && k + 1 == count;
    const double before = distance_of(discs[(k + count - 1) % count].centre, discs[k].centre);
    const double after = distance_of(discs[(k + 1) % count].centre, discs[k].centre);
    const double first = begins ? after : before, second = ends ? before : after;
    const double offset = offsets_[face][k];
    discs[k].radius = std::sqrt(offset * offset + (first * first + second * second) / 8);
  }
}

CoverDisc& Covering::disc_at_vertex(const Ray& ray) {
  auto& discs = covers_[ray.face].discs;
  const CoveredPath& covered = covered_[ray.face][ray.path];
  return discs[(ray.begins ? covered.first : covered.last) % discs.size()];
}

CoverDisc& Covering::next_disc(const Ray& ray) {
  auto& discs = covers_[ray.face].discs;
  const CoveredPath& covered = covered_[ray.face][ray.path];
  return discs[(ray.begins ? covered.first + 1 : covered.last - 1) % discs.size()];
}

// A lone disc between two vertices stands where it can pass through the pairs of both.
void Covering::fit_lone_discs() {
  for (std::size_t face = 0; face < faces_.size(); ++face)
    for (std::size_t k = 0; k < covered_[face].size(); ++k) {
      const auto& [begin, end, first, last] = covered_[face][k];
      if (!begin.at_vertex || !end.at_vertex || last != first + 2) continue;
      const Path& path = network_.routes[face].paths[k];
      const double near = begin.foot, far = path.length - end.foot;
      covers_[face].discs[first + 1].centre =
          path.at((far * far + end.offset * end.offset - near * near - begin.offset * begin.offset) /
                  (2 * (far - near)))
              .point;
    }
}

void Covering::fit_to_vertices() {
  for (std::size_t v = 0; v < network_.vertices.size(); ++v) {
    const Vertex& vertex = network_.vertices[v];
    std::vector<Point> directions;
    for (const Ray& ray : vertex.rays) directions.push_back(unit(vertex.point, next_disc(ray).centre));
    set_pairs(vertex, radii_[v], angles_beside_rays(sectors_between(directions), with_one_[v]));
  }
  fit_lone_discs();
  for (std::size_t v = 0; v < network_.vertices.size(); ++v)
    for (const Ray& ray : network_.vertices[v].rays) {
      const auto& [at_vertex, foot, offset] = end_of(ray);
      disc_at_vertex(ray) = {network_.vertices[v].point, radii_[v]};
      CoverDisc& next = next_disc(ray);
      next.radius = std::hypot(distance_of(next.centre, network_.vertices[v].point) - foot, offset);
    }
}

// Pieces that faces share end at junctions, so that two places on a path stand for all.
bool Covering::is_shared(std::size_t face, std::size_t number) const {
  const Path& path = network_.routes[face].paths[number];
  for (std::size_t earlier = 0; earlier < face; ++earlier)
    if (std::ranges::all_of(std::array{0.4, 0.7}, [&](double share) {
          return lies_on(faces_[earlier], path.at(share * path.length).point, kTheSamePoint * size_.least());
        }))
      return true;
  return false;
}

std::vector<FaceCover> Covering::take_covers() {
  std::vector<FaceCover> all;
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    const auto& [discs, closed] = covers_[face];
    const std::size_t count = covered_[face].size();
    std::size_t shared = 0;
    while (shared < count && !is_shared(face, shared)) ++shared;
    if (shared == count) {
      all.push_back(covers_[face]);
      continue;
    }
    // Runs of paths between shared ones.
    const std::size_t start = closed ? shared : 0;
    FaceCover run{{}, false};
    for (std::size_t k = 0; k < count; ++k) {
      const CoveredPath& path = covered_[face][(start + k) % count];
      const bool skipped = is_shared(face, (start + k) % count);
      if (skipped && !run.discs.empty()) all.push_back(std::exchange(run, {{}, false}));
      if (skipped) continue;
      for (std::size_t disc = path.first + (run.discs.empty() ? 0 : 1); disc <= path.last; ++disc)
        run.discs.push_back(discs[disc % discs.size()]);
    }
    if (!run.discs.empty()) all.push_back(std::move(run));
  }
  return all;
}

}  // namespace

std::vector<FaceCover> cover_faces(const std::vector<CellFace>& faces, const CellSize& size,
                                   const RoomBeside& room, motion::Random& random) {
  Covering covering(faces, size, room);
  covering.size_vertices();
  for (std::size_t face = 0; face < faces.size(); ++face) {
    covering.place_discs(face, random);
    covering.choose_radii(face);
  }
  covering.fit_to_vertices();
  return covering.take_covers();
}

}  // namespace adit::dem
