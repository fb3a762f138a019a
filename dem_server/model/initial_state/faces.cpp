#include "dem_server/model/initial_state/faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace adit::dem {
namespace {

constexpr std::size_t kMostSides = 12;  // of a pore

double turn(const Discs& d, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return (d.x[b] - d.x[a]) * (d.y[c] - d.y[a]) - (d.y[b] - d.y[a]) * (d.x[c] - d.x[a]);
}

bool cross(const Discs& d, const Link& a, const Link& b) {
  if (a.first == b.first || a.first == b.second || a.second == b.first || a.second == b.second) return false;
  return turn(d, a.first, a.second, b.first) * turn(d, a.first, a.second, b.second) < 0 &&
         turn(d, b.first, b.second, a.first) * turn(d, b.first, b.second, a.second) < 0;
}

// Half links, of the link 2 k to its second, 2 k + 1 to its first disc, around each disc counter-clockwise.
class HalfLinks {
 public:
  HalfLinks(const Discs& discs, std::span<const Link> links) : links_(links), around_(discs.size()) {
    for (std::uint32_t k = 0; k < links.size(); ++k) {
      around_[links[k].first].push_back(2 * k);
      around_[links[k].second].push_back(2 * k + 1);
    }
  }

  std::uint32_t from(std::uint32_t half) const {
    return half % 2 == 0 ? links_[half / 2].first : links_[half / 2].second;
  }
  std::uint32_t to(std::uint32_t half) const { return from(half ^ 1); }
  const std::vector<std::uint32_t>& around(std::uint32_t disc) const { return around_[disc]; }

  void remove(std::uint32_t link) {
    std::erase(around_[links_[link].first], 2 * link);
    std::erase(around_[links_[link].second], 2 * link + 1);
  }
  void sort() {
    const auto angle = [this](std::uint32_t half) {
      const Link& link = links_[half / 2];
      return half % 2 == 0 ? std::atan2(link.y, link.x) : std::atan2(-link.y, -link.x);
    };
    for (auto& halves : around_) std::ranges::sort(halves, {}, angle);
  }
  // The next one of the face to the left: at the end of this one, clockwise from the way back.
  std::uint32_t next(std::uint32_t half) const {
    const auto& halves = around_[to(half)];
    const auto back = std::ranges::find(halves, half ^ 1);
    return back == halves.begin() ? halves.back() : *(back - 1);
  }

 private:
  std::span<const Link> links_;
  std::vector<std::vector<std::uint32_t>> around_;
};

// Of links that cross, only those over a gap can. They cross links near their own ends.
void remove_crossing(const Discs& discs, std::span<const Link> links, HalfLinks& halves) {
  const auto length = [&](std::uint32_t k) { return std::hypot(links[k].x, links[k].y); };
  std::vector<std::uint32_t> over_gaps;
  for (std::uint32_t k = 0; k < links.size(); ++k) {
    const double touching = discs.radius[links[k].first] + discs.radius[links[k].second];
    if (length(k) > (1 + 1e-6) * touching) over_gaps.push_back(k);
  }
  std::ranges::stable_sort(over_gaps, std::ranges::greater(), length);
  for (const std::uint32_t k : over_gaps) {
    const auto crossed_at = [&](std::uint32_t disc) {
      return std::ranges::any_of(halves.around(disc), [&](std::uint32_t to_neighbour) {
        return std::ranges::any_of(halves.around(halves.to(to_neighbour)), [&](std::uint32_t other) {
          return cross(discs, links[k], links[other / 2]);
        });
      });
    };
    if (crossed_at(links[k].first) || crossed_at(links[k].second)) halves.remove(k);
  }
}

}  // namespace

Faces find_faces(const Discs& discs, std::span<const Link> links) {
  HalfLinks halves(discs, links);
  remove_crossing(discs, links, halves);
  halves.sort();
  Faces faces{std::vector<bool>(discs.size(), false), std::vector<double>(links.size(), 0.0), {}};
  std::vector<bool> seen(2 * links.size(), false);
  std::vector<std::uint32_t> face;
  for (std::uint32_t disc = 0; disc < discs.size(); ++disc) {
    if (halves.around(disc).empty()) faces.border[disc] = true;
    for (const std::uint32_t start : halves.around(disc)) {
      if (seen[start]) continue;
      face.clear();
      double twice_area = 0, xs = 0, ys = 0;
      for (std::uint32_t half = start; !seen[half]; half = halves.next(half)) {
        seen[half] = true;
        face.push_back(half);
        twice_area += turn(discs, disc, halves.from(half), halves.to(half));
        xs += discs.x[halves.from(half)];
        ys += discs.y[halves.from(half)];
      }
      if (twice_area > 0 && face.size() <= kMostSides) {
        const auto corners = static_cast<double>(face.size());
        Face& inside = faces.inside.emplace_back(Face{twice_area / 2, xs / corners, ys / corners, {}});
        for (const std::uint32_t half : face) inside.corners.push_back(halves.from(half));
        for (const std::uint32_t half : face) faces.share[half / 2] += 0.5;
      } else {
        for (const std::uint32_t half : face) faces.border[halves.from(half)] = true;
      }
    }
  }
  return faces;
}

}  // namespace adit::dem
