#include "dem_server/model/reading/springs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>

#include "dem_server/model/placement/joint_lines.hpp"
#include "dem_server/model/placement/scene_checks.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

using geometry::Point;
using protocol::UserError;

// The disc nearest to a place among those that may be taken. UserError where it lies further than its
// diameter away.
std::uint32_t nearest(const Discs& discs, const Point& place, const std::string& path,
                      const std::function<bool(std::uint32_t)>& may_be_taken = {}) {
  double least = std::numeric_limits<double>::infinity();
  std::uint32_t found = 0;
  for (std::uint32_t i = 0; i < discs.size(); ++i) {
    const double dx = discs.x[i] - place.x, dy = discs.y[i] - place.y, square = dx * dx + dy * dy;
    if (square >= least || (may_be_taken && !may_be_taken(i))) continue;
    least = square;
    found = i;
  }
  if (!(std::sqrt(least) <= 2 * discs.radius[found]))
    throw UserError(path,
                    fmt::format("finds no particle within a diameter of ({:.6g}, {:.6g}) m; move it to one",
                                place.x, place.y));
  return found;
}

Spring read_spring(const scene::ParticleSpring& spring, const std::string& path, const Discs& discs) {
  const std::uint32_t first = nearest(discs, {spring.from().x(), spring.from().y()}, path + ".from");
  const std::uint32_t second = nearest(discs, {spring.to().x(), spring.to().y()}, path + ".to");
  if (first == second)
    throw UserError(path,
                    fmt::format("finds at both ends the particle at ({:.6g}, {:.6g}) m; move the ends apart",
                                discs.x[first], discs.y[first]));
  return {first,
          second,
          spring.stiffness(),
          spring.tension_only(),
          spring.pretension(),
          spring.strength(),
          spring.stage()};
}

void add_bolts(const scene::SegmentRing& ring, const Discs& discs, std::vector<Spring>& springs) {
  const std::string path = "particles.ring.bolts";
  const auto& bolts = ring.bolts();
  const double middle = 0.5 * (ring.inner_radius() + ring.outer_radius());
  const RingJoints joints(ring);
  for (std::uint32_t k = 0; k < ring.segments(); ++k) {
    const auto [rx, ry] = joints.direction(k);
    const auto end = [&](double side) {
      const Point place{ring.centre().x() + middle * rx - side * bolts.length() / 2 * ry,
                        ring.centre().y() + middle * ry + side * bolts.length() / 2 * rx};
      return nearest(discs, place, path, [&](std::uint32_t i) {
        const double x = discs.x[i] - ring.centre().x(), y = discs.y[i] - ring.centre().y();
        return (y * rx - x * ry >= 0) == (side > 0) && x * rx + y * ry > 0;
      });
    };
    springs.push_back({end(-1), end(1), bolts.stiffness(), true, bolts.pretension(), bolts.strength()});
  }
}

}  // namespace

std::vector<Spring> read_springs(const scene::Particles& particles, const Discs& discs) {
  std::vector<Spring> springs;
  for (int k = 0; k < particles.springs_size(); ++k)
    springs.push_back(
        read_spring(particles.springs(k), "particles.springs[" + std::to_string(k) + "]", discs));
  if (particles.ring().has_bolts()) add_bolts(particles.ring(), discs, springs);
  return springs;
}

}  // namespace adit::dem
