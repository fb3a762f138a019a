#include "dem_server/engines/general/polygons/overlap.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "dem_server/laws/pair_kinematics.hpp"

namespace adit::dem {
namespace {

using Corner = OverlapWork::Corner;

// What lies to the left of the way from a to b (Sutherland & Hodgman 1974, Commun. ACM 17, 32).
void cut(const geometry::Point& a, const geometry::Point& b, OverlapWork& work) {
  const auto left = [&](const Corner& c) { return across(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y); };
  work.next.clear();
  const std::size_t size = work.now.size();
  double here = size > 0 ? left(work.now.front()) : 0;
  for (std::size_t k = 0; k < size; ++k) {
    const Corner &one = work.now[k], &other = work.now[k + 1 < size ? k + 1 : 0];
    const double there = left(other);
    if (here >= 0) work.next.push_back(one);
    if ((here >= 0) != (there >= 0)) {
      const double share = here / (here - there);
      work.next.push_back(
          {one.x + share * (other.x - one.x), one.y + share * (other.y - one.y), here < 0 && one.of_first});
    }
    here = there;
  }
  std::swap(work.now, work.next);
}

}  // namespace

Overlap overlap_of(std::span<const geometry::Point> first, std::span<const geometry::Point> second,
                   OverlapWork& work) {
  work.now.clear();
  for (const geometry::Point& corner : first) work.now.push_back({corner.x, corner.y, true});
  for (std::size_t k = 0; k < second.size(); ++k) {
    cut(second[k], second[k + 1 < second.size() ? k + 1 : 0], work);
    if (work.now.size() < 3) return {};
  }
  // About its first corner, which keeps digits: area, its moments, and the sums over the first outline's
  // edges of normal times length and of the moments of these.
  const double x_0 = work.now.front().x, y_0 = work.now.front().y;
  double twice_area = 0, moment_x = 0, moment_y = 0, sx = 0, sy = 0, turning = 0;
  for (std::size_t k = 0; k < work.now.size(); ++k) {
    const Corner &one = work.now[k], &other = work.now[k + 1 < work.now.size() ? k + 1 : 0];
    const double ax = one.x - x_0, ay = one.y - y_0, bx = other.x - x_0, by = other.y - y_0;
    const double doubled = across(ax, ay, bx, by);
    twice_area += doubled;
    moment_x += doubled * (ax + bx);
    moment_y += doubled * (ay + by);
    if (!one.of_first) continue;
    sx += by - ay;
    sy -= bx - ax;
    turning += across((ax + bx) / 2, (ay + by) / 2, by - ay, -(bx - ax));
  }
  const double chord = std::hypot(sx, sy);
  if (!(twice_area > 0) || chord == 0) return {};
  const double x = moment_x / (3 * twice_area), y = moment_y / (3 * twice_area);
  const double off = (across(x, y, sx, sy) - turning) / (chord * chord);
  return {.area = twice_area / 2,
          .nx = sx / chord,
          .ny = sy / chord,
          .chord = chord,
          .middle_x = x_0 + x,
          .middle_y = y_0 + y,
          .x = x_0 + x - off * sy,
          .y = y_0 + y + off * sx};
}

}  // namespace adit::dem
