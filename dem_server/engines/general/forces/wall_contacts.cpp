#include "dem_server/engines/general/forces/wall_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace adit::dem {

WallContacts::WallContacts(std::vector<MovingWall> walls, std::span<const double> radius,
                           const Particles& particles, double skin, bool overlaps_free)
    : walls_(std::move(walls)), states_(walls_.size()), radius_(radius.begin(), radius.end()), skin_(skin) {
  list(particles);
  if (overlaps_free)
    for (Touch& touch : touches_)
      touch.slack = std::max(0.0, -meet_wall(touch.wall, touch.disc, particles).gap);
}

double WallContacts::move(const protocol::Step& step) {
  double farthest = 0;
  if (!step.from_rest())
    for (State& s : states_) {
      s.ux += step.dt * s.vx;
      s.uy += step.dt * s.vy;
      farthest = std::max(farthest, step.dt * std::hypot(s.vx, s.vy));
    }
  return farthest;
}

void WallContacts::drive(const protocol::Step& step) {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const double factor = step.relax ? 0 : walls_[w].time(step.half_time());
    states_[w].vx = walls_[w].vx * factor;
    states_[w].vy = walls_[w].vy * factor;
  }
}

void WallContacts::stop() {
  for (State& s : states_) s.vx = s.vy = 0;
}

// The nearest point of the wall is where they meet.
Encounter WallContacts::meet_wall(std::uint32_t wall, std::uint32_t disc, const Particles& p,
                                  double dt) const {
  const MovingWall& w = walls_[wall];
  const State& s = states_[wall];
  const Body body{
      p.x[disc] + p.ux[disc], p.y[disc] + p.uy[disc], p.vx[disc],           p.vy[disc],
      p.spin[disc],           radius_[disc],          p.inverse_mass[disc], p.inverse_inertia[disc]};
  const double along_x = w.x_2 - w.x_1, along_y = w.y_2 - w.y_1;
  const double x = body.x - (w.x_1 + s.ux), y = body.y - (w.y_1 + s.uy);
  const double squared = along_x * along_x + along_y * along_y;
  const double share = std::clamp((x * along_x + y * along_y) / squared, 0.0, 1.0);
  const double dx = share * along_x - x, dy = share * along_y - y, distance = std::hypot(dx, dy);
  const double length = std::sqrt(squared);
  const double nx = distance > 0 ? dx / distance : -along_y / length,
               ny = distance > 0 ? dy / distance : along_x / length;
  const Body second{0, 0, s.vx, s.vy, 0, 0, 0, 0};
  return laws::at(body, second, nx, ny, distance, distance - body.radius, distance, 0, dt, 1);
}

void WallContacts::list(const Particles& p) {
  std::vector<Touch> fresh;
  auto old = touches_.begin();
  for (std::uint32_t w = 0; w < walls_.size(); ++w)
    for (std::uint32_t i = 0; i < p.size(); ++i) {
      if (!(meet_wall(w, i, p).gap <= skin_)) continue;
      while (old != touches_.end() && (old->wall < w || (old->wall == w && old->disc < i))) ++old;
      const bool kept = old != touches_.end() && old->wall == w && old->disc == i;
      fresh.push_back(kept ? *old : Touch{.wall = w, .disc = i});
    }
  touches_ = std::move(fresh);
}

void WallContacts::pull(double dt, Particles& p) {
  for (State& s : states_) {
    work_ += dt / 2 * (s.fx * s.vx + s.fy * s.vy);
    s.fx = s.fy = 0;
  }
  for (Touch& touch : touches_) {
    const std::uint32_t i = touch.disc;
    const LinearContact& law = walls_[touch.wall].contact;
    Encounter e = meet_wall(touch.wall, i, p, dt);
    e.gap += touch.slack;
    ContactWork work;
    const Pull f = adit::dem::pull(law, e, dt, touch.springs, &work);
    const double spring = law.normal_stiffness * std::min(e.gap, 0.0);
    const double normal_dashpot = f.normal - spring, shear_dashpot = f.shear - touch.springs.shear_force;
    friction_ += work.friction;
    dashpots_ += dt / 2 *
                 ((normal_dashpot + touch.normal_dashpot) * e.stretch_rate +
                  (shear_dashpot + touch.shear_dashpot) * e.slip_rate);
    touch.normal = f.normal;
    touch.normal_dashpot = normal_dashpot;
    touch.shear_dashpot = shear_dashpot;
    const double fx = f.normal * e.nx - f.shear * e.ny, fy = f.normal * e.ny + f.shear * e.nx;
    p.fx[i] += fx;
    p.fy[i] += fy;
    p.moment[i] += f.shear * e.arm_1;
    states_[touch.wall].fx += fx;
    states_[touch.wall].fy += fy;
  }
  for (const State& s : states_) work_ += dt / 2 * (s.fx * s.vx + s.fy * s.vy);
}

double WallContacts::strain_energy() const {
  double twice = 0;
  for (const Touch& touch : touches_) {
    const LinearContact& law = walls_[touch.wall].contact;
    const double spring = touch.normal - touch.normal_dashpot, shear = touch.springs.shear_force;
    twice += spring * spring / law.normal_stiffness;
    if (law.shear_stiffness > 0) twice += shear * shear / law.shear_stiffness;
  }
  return twice / 2;
}

}  // namespace adit::dem
