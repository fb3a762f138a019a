#include "fdm_server/continuum.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace adit::fdm {

Continuum::Continuum(std::unique_ptr<Zones> zones, std::span<const double> masses, std::vector<Load> loads,
                     std::vector<Motion> motions)
    : zones_(std::move(zones)), points_(masses.size()) {
  for (std::size_t i = 0; i < masses.size(); ++i) {
    points_[kMass][i] = masses[i];
    points_[kInverseMassX][i] = points_[kInverseMassY][i] = 1 / masses[i];
  }
  for (auto& load : loads) loads_.push_back({std::move(load)});
  for (auto& motion : motions) {
    double mass = 0;
    for (const auto point : motion.points) {
      mass += masses[point];
      points_[motion.axis == Axis::kX ? kInverseMassX : kInverseMassY][point] = 0;
    }
    motions_.push_back({std::move(motion), mass});
  }
}

void Continuum::push(std::uint32_t point, double x, double y) {
  points_[kVx][point] += points_[kInverseMassX][point] * x;
  points_[kVy][point] += points_[kInverseMassY][point] * y;
  if (points_[kInverseMassX][point] == 0) hold(Axis::kX, point, x);
  if (points_[kInverseMassY][point] == 0) hold(Axis::kY, point, y);
}

// The impulse on a component that does not yield is taken up by the reaction of its motion, which was found
// at the last step without it.
void Continuum::hold(Axis axis, std::uint32_t point, double impulse) {
  for (auto& prescribed : motions_) {
    if (prescribed.motion.axis != axis || !std::ranges::binary_search(prescribed.motion.points, point))
      continue;
    const double force = impulse / last_kick_;
    prescribed.reaction -= force;
    external_work_ -= last_dt_ * prescribed.before * force / 2;
  }
}

void Continuum::step(std::uint64_t n, double dt, Energies* wanted) {
  zones_->add_forces(dt,
                     {points_[kVx].data(), points_[kVy].data(), points_[kFx].data(), points_[kFy].data()});
  apply_loads(n, dt);
  find_reactions(n, dt);
  if (wanted) *wanted = energies(n, dt);
  last_dt_ = dt;
  last_kick_ = n == 0 ? dt / 2 : dt;
  move_and_predict(dt, last_kick_);
}

void Continuum::apply_loads(std::uint64_t n, double dt) {
  const auto vx = points_[kVx], vy = points_[kVy], fx = points_[kFx], fy = points_[kFy];
  for (auto& [load, last_factor] : loads_) {
    const double factor = load.factor(static_cast<double>(n) * dt);
    double power = 0;  // of the unit load
    for (std::size_t i = 0; i < load.points.size(); ++i) {
      const auto point = load.points[i];
      power += load.fx[i] * vx[point] + load.fy[i] * vy[point];
      fx[point] += factor * load.fx[i];
      fy[point] += factor * load.fy[i];
    }
    if (n > 0) external_work_ += dt * power * (last_factor + factor) / 2;
    last_factor = factor;
  }
}

// The reaction of a motion is what it adds to the other forces: R = m (v(n+1/2) - v(n-1/2))/dt - f.
void Continuum::find_reactions(std::uint64_t n, double dt) {
  for (auto& prescribed : motions_) {
    const auto& motion = prescribed.motion;
    const auto force = points_[motion.axis == Axis::kX ? kFx : kFy];
    const double next = motion.velocity * motion.factor((static_cast<double>(n) + 0.5) * dt);
    prescribed.before = n == 0 ? -next : prescribed.after;
    prescribed.after = next;
    double reaction = prescribed.mass * (next - prescribed.before) / dt;
    for (const auto point : motion.points) reaction -= force[point];
    if (n > 0) external_work_ += dt * prescribed.before * (prescribed.reaction + reaction) / 2;
    prescribed.reaction = reaction;
  }
}

Energies Continuum::energies(std::uint64_t n, double dt) const {
  const auto product = [&](std::span<const double> v, std::span<const double> f,
                           std::span<const double> inverse_mass, std::size_t i) {
    const double kick = dt * inverse_mass[i] * f[i];
    return n == 0 ? -kick * kick / 4 : v[i] * (v[i] + kick);  // v(n-1/2) v(n+1/2)
  };
  double twice = 0;
  for (std::size_t i = 0; i < points_.rows(); ++i)
    twice += points_[kMass][i] * (product(points_[kVx], points_[kFx], points_[kInverseMassX], i) +
                                  product(points_[kVy], points_[kFy], points_[kInverseMassY], i));
  for (const auto& p : motions_)  // the loop above took v(n-1/2)^2 of them, and 0 at step 0
    twice += p.mass * (p.before * p.after - (n == 0 ? 0 : p.before * p.before));
  return {twice / 2, zones_->strain_energy(), external_work_};
}

void Continuum::move_and_predict(double dt, double kick) {
  const auto axis = [this, dt, kick](Column displacement, Column velocity, Column force,
                                     Column inverse_mass) {
    double *u = points_[displacement].data(), *v = points_[velocity].data(), *f = points_[force].data();
    const double* inverse = points_[inverse_mass].data();
    const std::size_t count = points_.rows();
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
      u[i] += dt * v[i];
      v[i] += kick * (inverse[i] * f[i]);
      f[i] = 0;
    }
  };
  axis(kUx, kVx, kFx, kInverseMassX);
  axis(kUy, kVy, kFy, kInverseMassY);
  for (const auto& prescribed : motions_) {
    const auto velocity = points_[prescribed.motion.axis == Axis::kX ? kVx : kVy];
    for (const auto point : prescribed.motion.points) velocity[point] = prescribed.after;
  }
}

std::optional<std::uint32_t> Continuum::first_non_finite() const {
  const auto vx = points_[kVx], vy = points_[kVy];
  for (std::size_t i = 0; i < points_.rows(); ++i)
    if (!std::isfinite(vx[i]) || !std::isfinite(vy[i])) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

}  // namespace adit::fdm
