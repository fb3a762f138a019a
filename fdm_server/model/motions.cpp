#include "fdm_server/model/motions.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "fdm_server/model/grid/selection.hpp"
#include "protocol/errors.hpp"
#include "protocol/foundation/body_course.hpp"
#include "protocol/participant/time_function.hpp"

namespace adit::fdm {
namespace {

using protocol::UserError;

double along(Axis axis, const scene::Velocity& velocity) {
  return axis == Axis::kX ? velocity.x() : velocity.y();
}

std::optional<double> along(Axis axis, const scene::Displacement& displacement) {
  if (axis == Axis::kX) return displacement.has_x() ? std::optional(displacement.x()) : std::nullopt;
  return displacement.has_y() ? std::optional(displacement.y()) : std::nullopt;
}

bool same_displacement(const scene::GridMotion& a, const scene::GridMotion& b, Axis axis) {
  return a.has_displacement() && b.has_displacement() && a.stage() == b.stage() &&
         along(axis, a.displacement()) == along(axis, b.displacement());
}

bool same_velocity(const scene::GridMotion& a, const scene::GridMotion& b, Axis axis) {
  if (a.has_body() || b.has_body()) return false;
  if (a.has_displacement() || b.has_displacement()) return same_displacement(a, b, axis);
  const double va = along(axis, a.velocity()), vb = along(axis, b.velocity());
  return va == vb && (va == 0 || a.time().SerializeAsString() == b.time().SerializeAsString());
}

// The motions, each with the points that no motion before it has.
class Motions {
 public:
  Motions(const scene::Continuum& scene, const Grid& grid)
      : scene_(scene), grid_(grid), owner_{std::vector(grid.x.size(), -1), std::vector(grid.x.size(), -1)} {}

  void add(int number);
  std::vector<PrescribedMotion> take() { return std::move(motions_); }

 private:
  std::vector<std::uint32_t> own(int number, Axis axis, std::span<const std::uint32_t> chosen);
  void add_velocity(int number, std::span<const std::uint32_t> chosen);
  void add_displacement(int number, std::span<const std::uint32_t> chosen);
  void add_body(int number, std::span<const std::uint32_t> chosen);

  const scene::Continuum& scene_;
  const Grid& grid_;
  std::array<std::vector<int>, 2> owner_;  // the motion of each point's x and y, or -1
  std::vector<PrescribedMotion> motions_;
};

std::string path_of(int number) {
  return fmt::format("continuum.motions[{}]", number);
}

std::vector<std::uint32_t> Motions::own(int number, Axis axis, std::span<const std::uint32_t> chosen) {
  const std::string kind = scene_.motions(number).has_displacement() ? "displacement" : "velocity";
  std::vector<std::uint32_t> points;
  for (const auto point : chosen) {
    int& before = owner_[axis == Axis::kX ? 0 : 1][point];
    if (before >= 0 && !same_velocity(scene_.motions(before), scene_.motions(number), axis))
      throw UserError(
          path_of(number) + "." + kind,
          fmt::format("prescribes another {} {} than motions[{}] at the grid point ({}, {}) m; "
                      "let one of the two areas leave it out",
                      axis == Axis::kX ? "x" : "y", kind, before, grid_.x[point], grid_.y[point]));
    if (before >= 0) continue;
    before = number;
    points.push_back(point);
  }
  return points;
}

void Motions::add_velocity(int number, std::span<const std::uint32_t> chosen) {
  const scene::GridMotion& motion = scene_.motions(number);
  const auto factor = [time = motion.time()](double t) { return protocol::evaluate(time, t); };
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    if (axis == Axis::kX ? !motion.velocity().has_x() : !motion.velocity().has_y()) continue;
    motions_.push_back({own(number, axis, chosen), axis, along(axis, motion.velocity()), factor});
  }
}

void Motions::add_displacement(int number, std::span<const std::uint32_t> chosen) {
  const scene::GridMotion& motion = scene_.motions(number);
  for (const Axis axis : {Axis::kX, Axis::kY})
    if (const auto displacement = along(axis, motion.displacement()))
      motions_.push_back(
          {own(number, axis, chosen), axis, 0, [](double) { return 0.0; }, *displacement, motion.stage()});
}

// v = v_0 + spin x (r - r_0): a motion for the points of each row, which have one velocity along x, and of
// each column.
void Motions::add_body(int number, std::span<const std::uint32_t> chosen) {
  const scene::BodyMotion& body = scene_.motions(number).body();
  const auto course = std::make_shared<const foundation::BodyCourse>(body, path_of(number) + ".body");
  std::map<double, std::vector<std::uint32_t>> rows, columns;
  for (const auto point : own(number, Axis::kX, chosen)) rows[grid_.y[point]].push_back(point);
  for (const auto point : own(number, Axis::kY, chosen)) columns[grid_.x[point]].push_back(point);
  for (auto& [y, points] : rows)
    motions_.push_back({std::move(points), Axis::kX, 1, [course, arm = y - body.centre().y()](double t) {
                          const auto velocity = course->at(t);
                          return velocity.x - velocity.spin * arm;
                        }});
  for (auto& [x, points] : columns)
    motions_.push_back({std::move(points), Axis::kY, 1, [course, arm = x - body.centre().x()](double t) {
                          const auto velocity = course->at(t);
                          return velocity.y + velocity.spin * arm;
                        }});
}

void Motions::add(int number) {
  const scene::GridMotion& motion = scene_.motions(number);
  const std::string path = path_of(number);
  if (motion.has_body() && (motion.has_velocity() || motion.has_time()))
    throw UserError(
        path + ".body",
        "is given beside `velocity` or `time`, but has its own velocities over time; leave one out");
  if (motion.has_displacement() && (motion.has_velocity() || motion.has_time() || motion.has_body()))
    throw UserError(
        path + ".displacement",
        "is given beside `velocity`, `time` or `body`, but holds its points at rest once statics have moved "
        "them; keep one");
  if (motion.has_displacement() && !motion.displacement().has_x() && !motion.displacement().has_y())
    throw UserError(path + ".displacement", "names no component; give x, y or both");
  if (motion.has_stage() && !motion.has_displacement())
    throw UserError(path + ".stage", "is that of a `displacement`, and none is given; leave it out");
  if (!motion.has_body() && !motion.has_displacement() && !motion.velocity().has_x() &&
      !motion.velocity().has_y())
    throw UserError(
        path + ".velocity",
        "names no component; give x, y or both (0 fixes a component), or a `displacement` or a `body`");
  const auto chosen = select_points(grid_, motion.where(), path + ".where");
  if (motion.has_body())
    add_body(number, chosen);
  else if (motion.has_displacement())
    add_displacement(number, chosen);
  else
    add_velocity(number, chosen);
}

}  // namespace

void require_statics_for_motions(const scene::Scene& scene) {
  if (scene.has_statics()) return;
  for (int number = 0; number < scene.continuum().motions_size(); ++number)
    if (scene.continuum().motions(number).has_displacement())
      throw UserError(path_of(number) + ".displacement",
                      "is imposed by statics, and the scene has none; give `statics: {}`, or a `velocity`");
}

std::vector<PrescribedMotion> resolve_motions(const scene::Continuum& scene, const Grid& grid) {
  Motions motions(scene, grid);
  for (int number = 0; number < scene.motions_size(); ++number) motions.add(number);
  return motions.take();
}

}  // namespace adit::fdm
