#include "dem_server/packing/voronoi/face_nuclei.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace adit::dem {
namespace {

using geometry::Point;

constexpr double kTooClose = 0.8;  // of the nuclei's offset from the face
constexpr double kFlat = 0.1;      // least offset, of the radius of the discs
constexpr double kSame = 1e-6;     // of the radius: the nucleus in a corner belongs to both its sides

struct Beside {
  std::array<Point, 2> nuclei;
  double offset;  // from the chord between the centres [m]
};

// Where the edges of two discs cut each other.
std::optional<Beside> cut(const CoverDisc& a, const CoverDisc& b) {
  const double x = b.centre.x - a.centre.x, y = b.centre.y - a.centre.y, apart = std::hypot(x, y);
  const double along = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
  const double square = a.radius * a.radius - along * along;
  const double flat = kFlat * std::min(a.radius, b.radius);
  if (!(square > flat * flat)) return std::nullopt;
  const double offset = std::sqrt(square);
  const Point foot{a.centre.x + along * x / apart, a.centre.y + along * y / apart};
  const Point out{-y / apart * offset, x / apart * offset};
  return Beside{{Point{foot.x + out.x, foot.y + out.y}, Point{foot.x - out.x, foot.y - out.y}}, offset};
}

class FaceNuclei {
 public:
  FaceNuclei(const Margin& margin, PointGrid& nuclei) : margin_(margin), nuclei_(nuclei) {}

  void add(const FaceCover& cover) {
    const DiscField own(cover.discs);
    const std::size_t count = cover.discs.size(), links = cover.closed ? count : count - 1;
    std::vector<bool> complete(count, true);
    for (std::size_t k = 0; k < links; ++k) {
      const std::size_t next = (k + 1) % count;
      const auto beside = cut(cover.discs[k], cover.discs[next]);
      if (beside && fits(*beside, own))
        place(*beside, kSame * cover.discs[k].radius);
      else
        complete[k] = complete[next] = false;
    }
    std::vector<CoverDisc> kept;
    for (std::size_t k = 0; k < count; ++k)
      if (complete[k]) kept.push_back(cover.discs[k]);
    fields_.emplace_back(std::move(kept));
  }

  std::vector<DiscField> take_fields() { return std::move(fields_); }

 private:
  bool fits(const Beside& beside, const DiscField& own) const {
    return std::ranges::all_of(beside.nuclei, [&](const Point& p) {
      return !margin_.holds(p) && !own.hold(p) &&
             std::ranges::none_of(fields_, [&](const DiscField& field) { return field.hold(p); }) &&
             !crowds(p, beside.offset);
    });
  }
  bool crowds(const Point& p, double offset) const {
    return nuclei_.any_near(p, kTooClose * offset, [&](const Point& other) {
      const double apart = std::hypot(other.x - p.x, other.y - p.y);
      return apart < kTooClose * offset && apart > kSame * offset;
    });
  }
  void place(const Beside& beside, double same) {
    for (const Point& p : beside.nuclei)
      if (!nuclei_.any_closer(p, same)) nuclei_.add(p);
  }

  const Margin& margin_;
  PointGrid& nuclei_;
  std::vector<DiscField> fields_;
};

}  // namespace

std::vector<DiscField> add_face_nuclei(const std::vector<FaceCover>& covers, const Margin& margin,
                                       PointGrid& nuclei) {
  FaceNuclei adding(margin, nuclei);
  for (const auto& cover : covers) adding.add(cover);
  return adding.take_fields();
}

}  // namespace adit::dem
