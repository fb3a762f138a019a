#include "dem_server/model/placement/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "dem_server/model/placement/scene_checks.hpp"
#include "dem_server/model/placement/uncovered.hpp"
#include "dem_server/packing/voronoi/cell_points.hpp"
#include "dem_server/packing/voronoi/face_path.hpp"
#include "protocol/errors.hpp"
#include "protocol/geometry/read_shape.hpp"
#include "protocol/geometry/selection.hpp"
#include "protocol/text.hpp"

namespace adit::dem {
namespace {

using geometry::Point;
using protocol::UserError;

Point point_of(const scene::Point& p) {
  return {p.x(), p.y()};
}

bool same(const CellFace& a, const CellFace& b) {
  const auto equal = [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; };
  if (a.index() != b.index()) return false;
  if (const auto* circle = std::get_if<FaceCircle>(&a)) {
    const auto& other = std::get<FaceCircle>(b);
    return equal(circle->centre, other.centre) && circle->radius == other.radius;
  }
  const auto &line = std::get<FaceLine>(a), &other = std::get<FaceLine>(b);
  return line.closed == other.closed && std::ranges::equal(line.corners, other.corners, equal);
}

std::string group_where(int group) {
  return fmt::format("particles.groups[{}].where", group);
}

std::string excavation_where(int excavation) {
  return fmt::format("particles.excavations[{}].where", excavation);
}

// The lines of a scene, each once, as far as they lie in the box. Throws UserError below the path of a line
// that cells cannot follow.
class Faces {
 public:
  Faces(const geometry::BoundingBox& box, const CellSize& size) : box_(box), size_(size) {}

  const std::vector<CellFace>& all() const { return faces_; }

  void add(const CellFace& face) {
    if (std::ranges::none_of(faces_, [&](const CellFace& other) { return same(face, other); }))
      faces_.push_back(face);
  }

  void add_circle(const scene::Point& centre, double radius, const std::string& path) {
    const double size = size_.at(point_of(centre));
    if (radius < kSmallestCircle * size)
      throw UserError(path, fmt::format("is {} m, less than half of the size of a cell, {} m; give more, or "
                                        "smaller cells",
                                        radius, size));
    add(FaceCircle{point_of(centre), radius});
  }

  void add_line(std::vector<Point> corners, bool closed = false) {
    add(FaceLine{std::move(corners), closed});
  }

  template <class Corners>
  void add_polygon(const Corners& corners) {
    std::vector<Point> points;
    for (const auto& corner : corners) points.push_back(point_of(corner));
    add_line(std::move(points), true);
  }

  // Those sides of a box that lie inside: all four, or what hangs together of them.
  void add_sides(double x_min, double x_max, double y_min, double y_max) {
    const double left = std::max(x_min, box_.x_min), right = std::min(x_max, box_.x_max),
                 lower = std::max(y_min, box_.y_min), upper = std::min(y_max, box_.y_max);
    if (!(left < right && lower < upper)) return;
    const std::array<Point, 4> corners = geometry::corners(geometry::BoundingBox{left, right, lower, upper});
    const std::array<bool, 4> inside{lower > box_.y_min, right < box_.x_max,
                                     upper<box_.y_max, left> box_.x_min};
    const auto count = std::ranges::count(inside, true);
    if (count == 4) {
      add_line({corners.begin(), corners.end()}, true);
      return;
    }
    for (std::size_t side = 0; side < 4; ++side) {
      if (!inside[side] || inside[(side + 3) % 4]) continue;  // not the first of a run
      std::vector<Point> line{corners[side]};
      for (std::size_t next = side; inside[next % 4]; ++next) line.push_back(corners[(next + 1) % 4]);
      add_line(std::move(line));
    }
  }

  void add_area(const scene::Area& area, const std::string& path) {
    constexpr double kOpen = std::numeric_limits<double>::infinity();
    add_sides(area.has_x_min() ? area.x_min() : -kOpen, area.has_x_max() ? area.x_max() : kOpen,
              area.has_y_min() ? area.y_min() : -kOpen, area.has_y_max() ? area.y_max() : kOpen);
    if (area.has_circle())
      add_circle(area.circle().centre(), area.circle().radius(), path + ".circle.radius");
    if (area.has_annulus()) add_annulus(area.annulus(), path + ".annulus");
    if (area.has_band()) {
      const auto four = geometry::read_band_corners(area.band(), path + ".band");
      add_line({four.begin(), four.end()}, true);
    }
    if (area.has_polygon()) {
      geometry::read_polygon(area.polygon(), path + ".polygon");  // refuses outlines that cross themselves
      add_polygon(area.polygon().corners());
      for (const auto& hole : area.polygon().holes()) add_polygon(hole.corners());
    }
  }

  template <class Annulus>
  void add_annulus(const Annulus& annulus, const std::string& path) {
    add_circle(annulus.centre(), annulus.inner_radius(), path + ".inner_radius");
    add_circle(annulus.centre(), annulus.outer_radius(), path + ".outer_radius");
  }

 private:
  geometry::BoundingBox box_;
  const CellSize& size_;
  std::vector<CellFace> faces_;
};

// What takes the place of a group: the groups after it, and what is excavated later than it begins.
std::vector<Cover> covers_of(int group, const scene::Particles& particles, const geometry::BoundingBox& box,
                             const CellSize& size) {
  const double reach = kTheSamePoint * size.least();
  std::vector<Cover> covers;
  const auto add = [&](const scene::Area& area, const std::string& path) {
    Faces outlines(box, size);
    outlines.add_area(area, path);
    covers.push_back({protocol::Places(area, path, -reach), outlines.all()});
  };
  for (int k = group + 1; k < particles.groups_size(); ++k)
    if (particles.groups(k).has_where()) add(particles.groups(k).where(), group_where(k));
  for (int k = 0; k < particles.excavations_size(); ++k)
    if (particles.excavations(k).stage() > particles.groups(group).stage())
      add(particles.excavations(k).where(), excavation_where(k));
  return covers;
}

// Lines end where something else takes the place of their group. What is left of them comes after whole
// lines: where both cannot be exact, what takes the place is.
void add_groups(const scene::Particles& particles, const geometry::BoundingBox& box, const CellSize& size,
                Faces& faces) {
  std::vector<FaceLine> remains;
  for (int k = 0; k < particles.groups_size(); ++k) {
    Faces outlines(box, size);
    outlines.add_area(particles.groups(k).where(), group_where(k));
    const auto covers = covers_of(k, particles, box, size);
    for (const CellFace& outline : outlines.all()) {
      const auto* line = std::get_if<FaceLine>(&outline);
      const auto parts =
          line == nullptr ? std::vector<FaceLine>{} : uncovered(*line, covers, kTheSamePoint * size.least());
      if (line == nullptr || (parts.size() == 1 && same(parts.front(), outline)))
        faces.add(outline);
      else
        remains.insert(remains.end(), parts.begin(), parts.end());
    }
  }
  for (const FaceLine& line : remains) faces.add(line);
}

std::vector<CellFace> faces_of(const scene::Particles& particles, const geometry::BoundingBox& box,
                               const CellSize& size) {
  Faces faces(box, size);
  if (particles.has_ring()) faces.add_annulus(particles.ring(), "particles.ring");
  add_groups(particles, box, size, faces);
  for (int k = 0; k < particles.excavations_size(); ++k)
    faces.add_area(particles.excavations(k).where(), excavation_where(k));
  faces.add_area(particles.within(), "particles.within");
  for (int k = 0; k < particles.joints_size(); ++k) {
    const auto& joint = particles.joints(k);
    require_two_ends(joint.from(), joint.to(), fmt::format("particles.joints[{}]", k), "joint");
    faces.add_line({point_of(joint.from()), point_of(joint.to())});
  }
  return faces.all();
}

std::string finer_path(const std::string& cells, std::size_t number) {
  return fmt::format("{}.finer[{}]", cells, number);
}

// A lining of less than two cells would be a chain.
template <class Annulus>
void require_two_rows(const Annulus& lining, const CellSize& size, const std::string& what) {
  constexpr int kPlaces = 36;
  const double thickness = lining.outer_radius() - lining.inner_radius(),
               radius = (lining.outer_radius() + lining.inner_radius()) / 2;
  double largest = 0;
  for (int k = 0; k < kPlaces; ++k) {
    const double angle = 2 * std::numbers::pi * k / kPlaces;
    largest = std::max(largest, size.at({lining.centre().x() + radius * std::cos(angle),
                                         lining.centre().y() + radius * std::sin(angle)}));
  }
  if (largest > thickness / 2)
    throw UserError(
        "particles.cells.size",
        fmt::format("is {} m, more than half of the thickness of {}, {:.4g} m; give at most {:.4g} m there",
                    largest, what, thickness, thickness / 2));
}

void require_rows_in_linings(const scene::Particles& particles, const CellSize& size) {
  if (particles.has_ring()) require_two_rows(particles.ring(), size, "the ring");
  for (const auto& group : particles.groups())
    if (group.where().has_annulus())
      require_two_rows(group.where().annulus(), size, "the group " + protocol::quote(group.name()));
}

// A place that no cell is in or beside was not meant.
void require_cells_in_finer(const CellSize& size, const VoronoiCells& cells, const std::string& path) {
  for (std::size_t k = 0; k < size.finer().size(); ++k) {
    const auto& [distance, finest] = size.finer()[k];
    bool any = false;
    for (std::size_t i = 0; i < cells.size() && !any; ++i) any = distance({cells.x[i], cells.y[i]}) <= finest;
    if (!any) protocol::refuse_empty(finer_path(path, k) + ".where", "cells");
  }
}

// Summed over squares of the box.
double expected_number(const geometry::BoundingBox& box, const CellSize& size) {
  constexpr double kAreaOfCell = 0.8660254;  // over the square of the size
  constexpr int kSquares = 128;              // along each side
  const double width = (box.x_max - box.x_min) / kSquares, height = (box.y_max - box.y_min) / kSquares;
  double number = 0;
  for (int i = 0; i < kSquares; ++i)
    for (int j = 0; j < kSquares; ++j) {
      const double there = size.at({box.x_min + (i + 0.5) * width, box.y_min + (j + 0.5) * height});
      number += width * height / (kAreaOfCell * there * there);
    }
  return number;
}

}  // namespace

void CellShapes::keep_only(const std::vector<bool>& keep) {
  constexpr std::uint32_t kGone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(keep.size(), kGone);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i]) place[i] = kept++;
  dem::keep_only(keep, area, polar_moment, outlines);
  std::erase_if(facets, [&](const Facet& f) { return place[f.first] == kGone || place[f.second] == kGone; });
  for (Facet& facet : facets) {
    facet.first = place[facet.first];
    facet.second = place[facet.second];
  }
}

CellSize size_of(const scene::CellPacking& cells, const std::string& path) {
  std::vector<FinerPlace> finer;
  for (int k = 0; k < cells.finer_size(); ++k) {
    const scene::FinerCells& wanted = cells.finer(k);
    const std::string at = finer_path(path, static_cast<std::size_t>(k));
    if (wanted.where().has_group())
      throw UserError(at + ".where.group",
                      "is given, but cells have no groups yet; state the place by shapes");
    if (wanted.size() >= cells.size())
      throw UserError(at + ".size", fmt::format("is {} m, but the other cells have {} m; give less",
                                                wanted.size(), cells.size()));
    const protocol::Places places(wanted.where(), at + ".where", 0);
    finer.push_back({[places](const Point& p) { return places.distance(p.x, p.y); }, wanted.size()});
  }
  return {cells.size(), std::move(finer)};
}

Placement place_cells(const scene::Particles& particles) {
  const scene::CellPacking& wanted = particles.cells();
  const std::string path = "particles.cells";
  const geometry::BoundingBox box = box_of(wanted);
  const CellSize size = size_of(wanted, path);
  require_room_for(expected_number(box, size), size.least(), path + ".size");
  require_rows_in_linings(particles, size);
  VoronoiCells cells;
  try {
    cells = voronoi_cells(pack_cells({box, size, faces_of(particles, box, size), wanted.seed()}), box);
  } catch (const std::invalid_argument& why) {
    throw UserError(path, why.what());
  }
  require_cells_in_finer(size, cells, path);
  auto outlines = outlines_of(cells);
  Discs discs{std::move(cells.x), std::move(cells.y), std::move(cells.radius)};
  return {.discs = std::move(discs),
          .mass = {},
          .extent = box,
          .number = {},
          .cells = CellShapes{std::move(cells.area), std::move(cells.polar_moment), std::move(outlines),
                              std::move(cells.facets)}};
}

}  // namespace adit::dem
