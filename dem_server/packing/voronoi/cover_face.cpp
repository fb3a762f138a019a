#include "dem_server/packing/voronoi/cover_face.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem_server/packing/voronoi/face_path.hpp"

namespace adit::dem {
namespace {

using geometry::Point;

// Shares of the size.
constexpr double kOffset = 0.5, kLeastOffset = 0.12;  // of nuclei from the face
constexpr double kSpacing = 0.866;                    // cells size deep then have the area of a hexagonal one
constexpr double kCorner = 0.7, kSharpest = 1.2, kInCorner = 0.35;  // distance of the nucleus in a corner
constexpr double kStep = 0.125;                                     // in which the spacing is summed up

constexpr double kOffsetOfRoom = 0.25;      // two nuclei side by side share the room between two faces
constexpr double kSpacingOfOffset = 2.6;    // at most
constexpr double kJitter = 0.15;            // of the spacing
constexpr double kJitterOfFlatness = 0.45;  // the offset then varies alike where nuclei are close to a face
constexpr std::size_t kFewestAround = 5;

// A corner or an end of a line at which a disc is centred.
struct Corner {
  Point point;
  bool sharp = false;
  double radius = 0;            // of its disc if it is sharp [m]
  double foot = 0, offset = 0;  // of the nucleus in it: along either side, and from it [m]
};

class Covering {
 public:
  Covering(std::size_t face, double size, const RoomBeside& room, motion::Random& random)
      : face_(face), size_(size), room_(room), random_(random) {}

  FaceCover line(const FaceLine& line);
  FaceCover circle(const FaceCircle& circle);

 private:
  // Where faces meet, they cannot both be exact, and smaller cells would not help.
  double offset(const Path::Place& place) const {
    const double of_room = kOffsetOfRoom * room_.at(place.point, place.normal, face_);
    return of_room < kLeastOffset * size_ ? kOffset * size_ : std::min(of_room, kOffset * size_);
  }
  double spacing(double offset) const { return std::min(kSpacing * size_, kSpacingOfOffset * offset); }

  // Places from `from` to `to`, `first`, first + 1, … spacings from `from`; `last` are left after the last.
  std::vector<double> spread(const Path& path, double from, double to, double first, double last,
                             std::size_t fewest);
  std::vector<double> between(const Path& path, const Corner& a, const Corner& b);
  void size_corner(Corner& corner, const Path& before, const Path& after) const;
  void add(const Path::Place& place) {
    cover_.discs.push_back({place.point, 0});
    offsets_.push_back(offset(place));
    corners_.push_back(nullptr);
  }
  void choose_radii();
  void fit_to_corner(std::size_t k);

  std::size_t face_;
  double size_;
  const RoomBeside& room_;
  motion::Random& random_;
  FaceCover cover_;
  std::vector<double> offsets_;         // that the nuclei near each disc should have [m]
  std::vector<const Corner*> corners_;  // the sharp corner at which a disc is centred, or null
};

// The number of spacings that have passed grows along the way as 1 / spacing; the places are where it passes
// whole numbers, each moved at random.
std::vector<double> Covering::spread(const Path& path, double from, double to, double first, double last,
                                     std::size_t fewest) {
  const auto steps = static_cast<std::size_t>(std::ceil(std::max((to - from) / (kStep * size_), 1.0)));
  const double step = (to - from) / static_cast<double>(steps);
  std::vector<double> passed{0}, offsets;
  for (std::size_t k = 0; k < steps; ++k) {
    offsets.push_back(offset(path.at(from + (static_cast<double>(k) + 0.5) * step)));
    passed.push_back(passed.back() + step / spacing(offsets.back()));
  }
  const double whole = std::round(passed.back() - first - last) + 1;
  const auto count = static_cast<std::size_t>(std::max(whole, static_cast<double>(fewest)));
  if (count == 0) return {};
  const double stretch = passed.back() / (static_cast<double>(count) - 1 + first + last);
  const auto step_at = [&](double number) {
    return static_cast<std::size_t>(std::upper_bound(passed.begin() + 1, passed.end() - 1, number) -
                                    passed.begin() - 1);
  };
  std::vector<double> places;
  for (std::size_t k = 0; k < count; ++k) {
    double number = stretch * (static_cast<double>(k) + first);
    const double flat = offsets[step_at(number)], flatness = flat / spacing(flat);
    number +=
        stretch * std::min(kJitter, kJitterOfFlatness * flatness * flatness) * (2 * random_.uniform() - 1);
    const std::size_t in = step_at(number);
    places.push_back(
        from + step * (static_cast<double>(in) + (number - passed[in]) / (passed[in + 1] - passed[in])));
  }
  return places;
}

// The places between two corners. Beside a sharp corner, half a spacing follows on its nucleus. One disc
// alone between two sharp corners must pass through the nuclei of both.
std::vector<double> Covering::between(const Path& path, const Corner& a, const Corner& b) {
  auto places = spread(path, a.foot, path.length - b.foot, a.sharp ? 0.5 : 1, b.sharp ? 0.5 : 1,
                       a.sharp && b.sharp ? 1 : 0);
  if (a.sharp && b.sharp && places.size() == 1) {
    const double far = path.length - b.foot;
    places[0] =
        (far * far + b.offset * b.offset - a.foot * a.foot - a.offset * a.offset) / (2 * (far - a.foot));
  }
  return places;
}

// Scaled down where there is little room beside the corner or along its sides.
void Covering::size_corner(Corner& corner, const Path& before, const Path& after) const {
  const Point back = unit(corner.point, before.at(before.length - kStep * size_).point);
  const Point on = unit(corner.point, after.at(kStep * size_).point);
  const double half = std::acos(std::clamp(back.x * on.x + back.y * on.y, -1.0, 1.0)) / 2;
  const double full = size_ * std::clamp(kInCorner / std::sin(half), kCorner, kSharpest);
  const double beside = std::min(offset(before.at(before.length)), offset(after.at(0))) / (kOffset * size_);
  const double along = std::min(before.length, after.length) / (3 * full * std::cos(half));
  corner.radius = full * std::min({1.0, beside, along});
  corner.foot = corner.radius * std::cos(half);
  corner.offset = corner.radius * std::sin(half);
}

void Covering::choose_radii() {
  auto& discs = cover_.discs;
  const std::size_t count = discs.size();
  for (std::size_t k = 0; k < count; ++k) {
    const bool begins = !cover_.closed && k == 0, ends = !cover_.closed && k + 1 == count;
    const double before = distance_of(discs[(k + count - 1) % count].centre, discs[k].centre);
    const double after = distance_of(discs[(k + 1) % count].centre, discs[k].centre);
    const double first = begins ? after : before, second = ends ? before : after;
    discs[k].radius = std::sqrt(offsets_[k] * offsets_[k] + (first * first + second * second) / 8);
  }
  for (std::size_t k = 0; k < count; ++k)
    if (corners_[k] != nullptr) fit_to_corner(k);
}

// The discs before and after a sharp corner pass through the nucleus on its bisector.
void Covering::fit_to_corner(std::size_t k) {
  auto& discs = cover_.discs;
  auto &before = discs[(k + discs.size() - 1) % discs.size()], &after = discs[(k + 1) % discs.size()];
  const Point centre = discs[k].centre, back = unit(centre, before.centre), on = unit(centre, after.centre);
  const Point towards = unit({0, 0}, {back.x + on.x, back.y + on.y});
  const double radius = discs[k].radius = corners_[k]->radius;
  const Point nucleus{centre.x + radius * towards.x, centre.y + radius * towards.y};
  before.radius = distance_of(before.centre, nucleus);
  after.radius = distance_of(after.centre, nucleus);
}

FaceCover Covering::line(const FaceLine& line) {
  const std::vector<Point> points = opened(line);
  const std::vector<double> turns = turns_of(points, line.closed);
  const std::vector<std::size_t> kept = corners_with_discs(points, turns, size_);
  std::vector<Corner> corners;
  std::vector<Path> paths;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    corners.push_back({points[kept[k]], is_sharp(turns[kept[k]])});
    if (k + 1 < kept.size())
      paths.push_back(path_along({points.begin() + static_cast<std::ptrdiff_t>(kept[k]),
                                  points.begin() + static_cast<std::ptrdiff_t>(kept[k + 1]) + 1}));
  }
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (corners[k].sharp)
      size_corner(corners[k], paths[k > 0 ? k - 1 : paths.size() - 1], paths[k % paths.size()]);

  cover_.closed = line.closed;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    add(paths[k].at(0));
    if (corners[k].sharp) corners_.back() = &corners[k];
    for (const double place : between(paths[k], corners[k], corners[k + 1])) add(paths[k].at(place));
  }
  if (!line.closed) add(paths.back().at(paths.back().length));
  choose_radii();
  return std::move(cover_);
}

FaceCover Covering::circle(const FaceCircle& circle) {
  cover_.closed = true;
  const Path path = path_around(circle, 2 * std::numbers::pi * random_.uniform());
  std::vector<double> places = spread(path, 0, path.length, 0.5, 0.5, kFewestAround);
  double twice_area = 0;  // over the square of the radius
  for (std::size_t k = 0; k < places.size(); ++k) {
    add(path.at(places[k]));
    const double next = k + 1 < places.size() ? places[k + 1] : places[0] + path.length;
    twice_area += std::sin((next - places[k]) / circle.radius);
  }
  const double scale = std::sqrt(2 * std::numbers::pi / twice_area);
  for (auto& disc : cover_.discs)
    disc.centre = {circle.centre.x + scale * (disc.centre.x - circle.centre.x),
                   circle.centre.y + scale * (disc.centre.y - circle.centre.y)};
  choose_radii();
  return std::move(cover_);
}

}  // namespace

FaceCover cover_face(const CellFace& face, std::size_t number, double size, const RoomBeside& room,
                     motion::Random& random) {
  Covering covering(number, size, room, random);
  if (const auto* line = std::get_if<FaceLine>(&face)) return covering.line(*line);
  return covering.circle(std::get<FaceCircle>(face));
}

}  // namespace adit::dem
