#include "dem_server/model/reading/springs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "dem_server/model/placement/joint_lines.hpp"
#include "dem_server/model/placement/scene_checks.hpp"
#include "protocol/errors.hpp"
#include "protocol/text.hpp"

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

// How its force follows from its opening.
void read_law(const scene::ParticleSpring& given, const std::string& path, Spring& spring) {
  if (given.has_curve() == given.has_stiffness())
    throw UserError(path + ".stiffness",
                    given.has_curve() ? "is given beside `curve`, which says the force; leave one of them out"
                                      : "is missing; give it, or a `curve` of force by opening");
  if (!given.has_curve()) {
    spring.stiffness = given.stiffness();
    spring.tension_only = given.tension_only();
    spring.pretension = given.pretension();
  } else {
    for (const auto& [is_given, key] :
         {std::pair{given.has_tension_only() && given.tension_only(), ".tension_only"},
          std::pair{given.has_pretension(), ".pretension"}})
      if (is_given)
        throw UserError(path + key,
                        "is given beside `curve`, which says the force at every opening; leave it out");
    const auto& [opening, force] = std::pair(given.curve().opening(), given.curve().force());
    spring.curve = std::make_shared<protocol::ForceCurve>(std::vector<double>(opening.begin(), opening.end()),
                                                          std::vector<double>(force.begin(), force.end()));
    spring.stiffness = spring.curve->steepest();
    if (spring.stiffness == 0)
      throw UserError(path + ".curve.force", "is the same at every opening; give a force that depends on it");
  }
  const double at_rest = spring.curve ? spring.curve->force(0) : spring.pretension;
  if (given.clearance() > 0 && at_rest != 0)
    throw UserError(
        path + ".clearance",
        fmt::format("is given, but the spring bears {:.6g} N at opening 0, where a clearance leaves "
                    "no force; leave one of them out",
                    at_rest));
  spring.clearance = given.clearance();
}

std::optional<PlaneVector> read_direction(const scene::ParticleSpring& given, const std::string& path) {
  if (!given.has_direction()) return std::nullopt;
  const double x = given.direction().x(), y = given.direction().y(), length = std::hypot(x, y);
  if (!(length > 0))
    throw UserError(path + ".direction", "has no length; give a vector such as {x: 1, y: 0}");
  return PlaneVector{x / length, y / length};
}

Spring read_spring(const scene::ParticleSpring& spring, const std::string& path, const Discs& discs) {
  const std::uint32_t first = nearest(discs, {spring.from().x(), spring.from().y()}, path + ".from");
  const std::uint32_t second = nearest(discs, {spring.to().x(), spring.to().y()}, path + ".to");
  if (first == second)
    throw UserError(path,
                    fmt::format("finds at both ends the particle at ({:.6g}, {:.6g}) m; move the ends apart",
                                discs.x[first], discs.y[first]));
  Spring read{first, second, 0, false, 0, spring.strength(), spring.name()};
  read_law(spring, path, read);
  read.stage = spring.stage();
  read.direction = read_direction(spring, path);
  return read;
}

void add_bolts(const scene::SegmentRing& ring, const Discs& discs, std::vector<Spring>& springs) {
  const std::string path = "particles.ring.bolts";
  const auto& bolts = ring.bolts();
  const double middle = 0.5 * (ring.inner_radius() + ring.outer_radius());
  const RingJoints joints(ring);
  for (std::uint32_t k = 0; k < ring.segments(); ++k) {
    const auto [rx, ry] = joints.direction(k);
    const auto end = [&, rx = rx, ry = ry](double side) {
      const Point place{ring.centre().x() + middle * rx - side * bolts.length() / 2 * ry,
                        ring.centre().y() + middle * ry + side * bolts.length() / 2 * rx};
      return nearest(discs, place, path, [&](std::uint32_t i) {
        const double x = discs.x[i] - ring.centre().x(), y = discs.y[i] - ring.centre().y();
        return (y * rx - x * ry >= 0) == (side > 0) && x * rx + y * ry > 0;
      });
    };
    springs.push_back({end(-1), end(1), bolts.stiffness(), true, bolts.pretension(), bolts.strength(),
                       "bolt_" + std::to_string(k)});
  }
}

}  // namespace

std::vector<Spring> read_springs(const scene::Particles& particles, const Discs& discs) {
  std::vector<Spring> springs;
  for (int k = 0; k < particles.springs_size(); ++k) {
    const std::string path = "particles.springs[" + std::to_string(k) + "]";
    const Spring spring = read_spring(particles.springs(k), path, discs);
    if (!spring.name.empty() && std::ranges::find(springs, spring.name, &Spring::name) != springs.end())
      throw UserError(path + ".name", fmt::format("is {}, like that of an earlier spring; give each its own",
                                                  protocol::quote(spring.name)));
    springs.push_back(spring);
  }
  if (particles.ring().has_bolts()) add_bolts(particles.ring(), discs, springs);
  return springs;
}

}  // namespace adit::dem
