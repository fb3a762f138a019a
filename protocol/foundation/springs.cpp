#include "protocol/foundation/springs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace adit::foundation {
namespace {

double at(const Bracket& place, const std::vector<double>& values) {
  return std::lerp(values[place.before], values[place.after], place.share);
}

}  // namespace

Springs::Springs(Direction direction, const SpringLaw& law, std::shared_ptr<const GroundCourse> ground,
                 const std::vector<HeldPoint>& points)
    : direction_(direction), law_(law), ground_(std::move(ground)) {
  for (const HeldPoint& held : points)
    if (held.area > 0) points_.push_back({held.point, held.area, ground_->place(held.x)});
}

Springs Springs::take(const std::vector<bool>& chosen) {
  Springs taken = *this;
  std::erase_if(taken.points_, [&](const Point& point) { return !chosen[point.point]; });
  std::erase_if(points_, [&](const Point& point) { return chosen[point.point]; });
  return taken;
}

void Springs::mark(std::vector<bool>& points) const {
  for (const Point& point : points_) points[point.point] = true;
}

void Springs::tie(std::span<const std::uint32_t> points) {
  for (Point& point : points_) point.tied = std::ranges::find(points, point.point) != points.end();
}

bool Springs::holds(std::uint32_t begin, std::uint32_t end) const {
  return std::ranges::any_of(points_,
                             [=](const Point& point) { return begin <= point.point && point.point < end; });
}

void Springs::stretch(Point& point, double by) const {
  const double limit = (1 - law_.hardening) * law_.slip_stress;
  point.elongation += by;
  point.slider = std::clamp(point.slider + (1 - law_.hardening) * law_.stiffness * by, -limit, limit);
}

double Springs::stored(const Point& point) const {
  const double elastic = law_.hardening * law_.stiffness, sliding = law_.stiffness - elastic;
  return point.area *
         (elastic * point.elongation * point.elongation + point.slider * point.slider / sliding) / 2;
}

double Springs::spring(const Point& point) const {
  return point.area * (law_.hardening * law_.stiffness * point.elongation + point.slider);
}

void Springs::pull(const protocol::Step& step, const PointMotion& motion) {
  ground_->velocities(direction_, step.half_time() - step.dt, before_);
  ground_->velocities(direction_, step.time(), now_);
  if (step.relax) {  // the ground stands still, too
    std::ranges::fill(before_, 0.0);
    std::ranges::fill(now_, 0.0);
  }
  for (Point& point : points_) {
    point.stored_before = stored(point);
    if (!step.from_rest())
      stretch(point, step.dt * (at(point.place, before_) - motion.velocity[point.point]));
    motion.force[point.point] += spring(point);
  }
}

void Springs::brake(const protocol::Step& step, const PointMotion& motion) {
  const bool moves = !step.from_rest();
  for (Point& point : points_) {
    const double v = motion.velocity[point.point], ground = at(point.place, before_);
    const double c = point.area * law_.dashpot, w = step.kick() / 2 * motion.inverse_mass[point.point];
    const double middle = moves ? v + (point.tied ? 0 : w * motion.force[point.point]) : 0;
    const double drag = c * (at(point.place, now_) - middle) / (1 + (moves ? c * w : 0));
    motion.force[point.point] += drag;
    const double force_before = std::exchange(point.force, spring(point) + drag);
    if (!moves) continue;
    const double impulse = step.dt * (force_before + point.force) / 2;
    work_ += ground * impulse;
    dissipated_ += (ground - v) * impulse - (stored(point) - point.stored_before);
  }
}

double Springs::stored() const {
  double sum = 0;
  for (const Point& point : points_) sum += stored(point);
  return sum;
}

}  // namespace adit::foundation
