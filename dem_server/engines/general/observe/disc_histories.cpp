#include "dem_server/engines/general/observe/disc_histories.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "dem_server/engines/general/observe/branches.hpp"
#include "dem_server/engines/general/observe/fragments.hpp"
#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

bool is_force(scene::Quantity quantity) {
  return quantity == scene::FORCE_X || quantity == scene::FORCE_Y;
}

bool is_of_circle(scene::Quantity quantity) {
  switch (quantity) {
    case scene::STRESS_XX:
    case scene::STRESS_YY:
    case scene::STRESS_XY:
    case scene::STRAIN_RATE_XX:
    case scene::STRAIN_RATE_YY:
    case scene::SHEAR_STRAIN_RATE_XY:
    case scene::COORDINATION:
    case scene::POROSITY:
      return true;
    default:
      return false;
  }
}

std::size_t wall_of(const scene::History& history, const std::string& path, const WallContacts& walls) {
  std::vector<std::string> names;
  for (const MovingWall& wall : walls.walls()) {
    if (wall.name == history.wall()) return names.size();
    names.push_back(wall.name);
  }
  throw UserError(path + ".wall",
                  fmt::format("is {}, but {} is a force on a wall; {}",
                              history.has_wall() ? protocol::quote(history.wall()) : "missing",
                              protocol::name_of(history.quantity()),
                              names.empty() ? "add it to particles.walls"
                                            : fmt::format("choose one of {}", fmt::join(names, ", "))));
}

Circle circle_of(const scene::History& history, const std::string& path, const Solver& solver) {
  if (!history.has_at()) throw UserError(path + ".at", "is missing; give the circle's middle, {x: …, y: …}");
  if (!history.has_radius())
    throw UserError(
        path + ".radius",
        fmt::format("is missing; {} of particles is a mean over a circle: give its radius, best ten of a "
                    "particle's or more",
                    protocol::name_of(history.quantity())));
  const Circle circle{history.at().x(), history.at().y(), history.radius()};
  const Particles& p = solver.particles();
  std::size_t inside = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (std::hypot(p.x[i] - circle.x, p.y[i] - circle.y) < circle.radius) ++inside;
  if (inside < 3)
    throw UserError(
        path + ".radius",
        fmt::format("is {:g} m, but the centres of {} particle(s) lie so near to ({:g}, {:g}) m; choose a "
                    "radius that holds three and more",
                    circle.radius, inside, circle.x, circle.y));
  return circle;
}

}  // namespace

DiscHistories::DiscHistories(const scene::Particles& scene, const Solver& solver)
    : motions_(scene, solver.particles(), solver.radius(), Histories::Others::kLeftOut) {
  for (int i = 0; i < scene.histories_size(); ++i) {
    const auto& history = scene.histories(i);
    const auto quantity = history.quantity();
    const std::string path = fmt::format("particles.histories[{}]", i);
    if (is_motion(quantity)) continue;
    Measure measure{static_cast<std::size_t>(i), quantity, {}, 0};
    if (is_force(quantity))
      measure.wall = wall_of(history, path, solver.walls());
    else if (is_of_circle(quantity))
      measure.circle = circle_of(history, path, solver);
    else
      throw UserError(
          path + ".quantity",
          fmt::format("is {}, which particles do not have; choose a motion, a stress, a strain rate, "
                      "coordination or porosity, or a force on a wall",
                      protocol::name_of(quantity)));
    measures_.push_back(measure);
  }
}

void DiscHistories::read(const Solver& solver, const protocol::Step& step,
                         google::protobuf::RepeatedField<double>& values) const {
  google::protobuf::RepeatedField<double> motions;
  motions_.read(solver.particles(), step, motions);
  const auto measured = measure(solver);
  int next_motion = 0;
  std::size_t next = 0;
  for (int column = 0; column < motions.size() + static_cast<int>(measured.size()); ++column)
    values.Add(next < measured.size() && measures_[next].column == static_cast<std::size_t>(column)
                   ? measured[next++]
                   : motions[next_motion++]);
}

std::vector<double> DiscHistories::measure(const Solver& solver) const {
  const auto any = [this](auto&& test) { return std::ranges::any_of(measures_, test, &Measure::quantity); };
  const Particles& p = solver.particles();
  std::vector<double> x, y;
  std::vector<Branch> branches;
  std::vector<std::uint32_t> coordination;
  if (any(is_of_circle)) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      x.push_back(p.x[i] + p.ux[i]);
      y.push_back(p.y[i] + p.uy[i]);
    }
    branches = branches_of(solver);
  }
  if (any([](scene::Quantity quantity) { return quantity == scene::COORDINATION; }))
    coordination = coordination_of(p.size(), touching_discs(solver));
  const auto strain_rate = [&](const Circle& circle) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return mean_strain_rate(circle, x, y, p.vx, p.vy).value_or(Tensor{kNone, kNone, kNone});
  };
  std::vector<double> values;
  for (const auto& [column, quantity, circle, wall] : measures_) switch (quantity) {
      case scene::STRESS_XX:
        values.push_back(mean_stress(circle, branches).xx);
        break;
      case scene::STRESS_YY:
        values.push_back(mean_stress(circle, branches).yy);
        break;
      case scene::STRESS_XY:
        values.push_back(mean_stress(circle, branches).xy);
        break;
      case scene::STRAIN_RATE_XX:
        values.push_back(strain_rate(circle).xx);
        break;
      case scene::STRAIN_RATE_YY:
        values.push_back(strain_rate(circle).yy);
        break;
      case scene::SHEAR_STRAIN_RATE_XY:
        values.push_back(2 * strain_rate(circle).xy);
        break;
      case scene::COORDINATION:
        values.push_back(mean_coordination(circle, x, y, coordination));
        break;
      case scene::POROSITY:
        values.push_back(porosity(circle, x, y, solver.radius()));
        break;
      case scene::FORCE_X:
        values.push_back(solver.walls().force(wall).x);
        break;
      default:
        values.push_back(solver.walls().force(wall).y);
    }
  return values;
}

}  // namespace adit::dem
