#include "dem_server/engines/general/forces/wall_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "dem_server/laws/spring.hpp"
#include "dem_server/model/nearest_on_wall.hpp"

namespace adit::dem {

WallContacts::WallContacts(std::vector<MovingWall> walls, std::span<const double> radius,
                           const Particles& particles, double skin, bool overlaps_free)
    : walls_(std::move(walls)), states_(walls_.size()), radius_(radius.begin(), radius.end()), skin_(skin) {
  list(particles);
  if (overlaps_free)
    for (Touch& touch : touches_)
      touch.slack = std::max(0.0, -kinematics(touch.wall, touch.disc, particles).elongation);
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

// They meet on the wall, which does not turn: all of the arm is the disc's.
PairKinematics WallContacts::kinematics(std::uint32_t wall, std::uint32_t disc, const Particles& p,
                                        double dt) const {
  const MovingWall& w = walls_[wall];
  const State& s = states_[wall];
  const double x = p.x[disc] + p.ux[disc] - (w.x_1 + s.ux), y = p.y[disc] + p.uy[disc] - (w.y_1 + s.uy);
  const auto [dx, dy] = to_wall(w, x, y);
  const double along_x = w.x_2 - w.x_1, along_y = w.y_2 - w.y_1;
  const double distance = std::hypot(dx, dy), length = std::sqrt(along_x * along_x + along_y * along_y);
  const double nx = distance > 0 ? dx / distance : -along_y / length,
               ny = distance > 0 ? dy / distance : along_x / length;
  // Beside the wall the direction is that of its normal; round an end it turns with the disc.
  const double turn_per_way = distance > 0 && !is_beside_wall(w, x, y) ? 1 / distance : 0;
  const double vx = s.vx - p.vx[disc], vy = s.vy - p.vy[disc];
  const double stretch_rate = along(nx, ny, vx, vy), half = 0.5 * dt * stretch_rate;
  const Arms arms{distance, 0};
  const double slip_rate =
      mid_step_slip_rate(across(nx, ny, vx, vy), half, half * turn_per_way, arms, 1, p.spin[disc], 0);
  return {nx,           ny,        distance,     distance - radius_[disc], arms.first, arms.second,
          stretch_rate, slip_rate, -p.spin[disc]};
}

void WallContacts::list(const Particles& p) {
  std::vector<Touch> fresh;
  auto old = touches_.begin();
  for (std::uint32_t w = 0; w < walls_.size(); ++w)
    for (std::uint32_t i = 0; i < p.size(); ++i) {
      if (!p.is_there(i) || !(kinematics(w, i, p).elongation <= skin_)) continue;
      while (old != touches_.end() && (old->wall < w || (old->wall == w && old->disc < i))) ++old;
      const bool kept = old != touches_.end() && old->wall == w && old->disc == i;
      fresh.push_back(kept ? *old : Touch{.wall = w, .disc = i});
    }
  touches_ = std::move(fresh);
}

void WallContacts::add_forces(const protocol::Step& step, Particles& p) {
  const double dt = step.from_rest() ? 0 : step.dt;
  for (State& s : states_) {
    work_ += dt / 2 * (s.fx * s.vx + s.fy * s.vy);
    s.fx = s.fy = 0;
  }
  for (Touch& touch : touches_) {
    const std::uint32_t i = touch.disc;
    const PairKinematics pair = kinematics(touch.wall, i, p, dt);
    const LinearContact& of_time = walls_[touch.wall].contact;
    const ContactForces f = forces(step.relax ? without_dashpots(of_time) : of_time, pair, dt,
                                   p.inverse_mass[i], p.inverse_inertia[i], touch);
    const PlaneVector force = vector_of(pair.nx, pair.ny, f.normal, f.shear);
    p.fx[i] += force.x;
    p.fy[i] += force.y;
    p.moment[i] += f.shear * pair.arm_1;
    states_[touch.wall].fx += force.x;
    states_[touch.wall].fy += force.y;
  }
  for (const State& s : states_) work_ += dt / 2 * (s.fx * s.vx + s.fy * s.vy);
}

ContactForces WallContacts::forces(const LinearContact& law, const PairKinematics& pair, double dt,
                                   double inverse_mass, double inverse_inertia, Touch& touch) {
  const double gap = pair.elongation + touch.slack, before = touch.shear;
  ContactForces f{0, 0}, dashpots{0, 0};
  touch.shear = 0;
  if (gap < 0) {
    const ContactSprings springs = contact_springs(law, gap, pair.slip_rate, dt, before);
    f = with_dashpots(law, springs, true, inverse_mass,
                      inverse_slip_mass(inverse_mass, {pair.arm_1, pair.arm_2}, inverse_inertia, 0),
                      pair.stretch_rate, pair.slip_rate, dt);
    dashpots = {f.normal - springs.normal, f.shear - springs.shear};
    touch.shear = springs.shear;
    if (law.shear_stiffness > 0)
      friction_ += stiffness_times_friction_work(springs, before) / law.shear_stiffness;
  }
  dashpots_ += dashpot_work(dt, touch.dashpots, dashpots, pair.stretch_rate, pair.slip_rate);
  touch.normal = f.normal;
  touch.dashpots = dashpots;
  return f;
}

double WallContacts::strain_energy() const {
  double sum = 0;
  for (const Touch& touch : touches_) {
    const LinearContact& law = walls_[touch.wall].contact;
    sum += spring_energy(touch.normal - touch.dashpots.normal, law.normal_stiffness);
    sum += spring_energy(touch.shear, law.shear_stiffness);
  }
  return sum;
}

}  // namespace adit::dem
