#include "dem_server/engines/general/forces/wall_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dem_server/engines/general/polygons/depth.hpp"
#include "dem_server/model/nearest_on_wall.hpp"

namespace adit::dem {

WallContacts::WallContacts(std::vector<MovingWall> walls, const CellPolygons& polygons,
                           const FacetSet& facets, const Particles& particles, double skin,
                           bool overlaps_free)
    : walls_(std::move(walls)), states_(walls_.size()), polygons_(polygons), skin_(skin) {
  list(particles);
  if (overlaps_free)
    for (Near& near : near_)
      near.slack = polygons_.empty() ? std::max(0.0, -of_disc(near, particles, 0).gap)
                                     : depth_in_cell(near, facets, particles);
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

PlaneVector WallContacts::place(std::uint32_t wall, std::uint32_t disc, const Particles& p) const {
  const MovingWall& w = walls_[wall];
  const State& s = states_[wall];
  return {p.x[disc] + p.ux[disc] - (w.x_1 + s.ux), p.y[disc] + p.uy[disc] - (w.y_1 + s.uy)};
}

// They meet on the wall, which does not turn: all of the arm is the disc's.
Encounter WallContacts::of_disc(const Near& near, const Particles& p, double dt) const {
  const auto [wall, disc] = std::pair(near.wall, near.disc);
  const MovingWall& w = walls_[wall];
  const State& s = states_[wall];
  const auto [x, y] = place(wall, disc, p);
  const auto [dx, dy] = to_wall(w, x, y);
  const double along_x = w.x_2 - w.x_1, along_y = w.y_2 - w.y_1;
  const double distance = std::hypot(dx, dy), length = std::sqrt(along_x * along_x + along_y * along_y);
  const double nx = distance > 0 ? dx / distance : -along_y / length,
               ny = distance > 0 ? dy / distance : along_x / length;
  // Beside the wall the direction is that of its normal; round an end it turns with the disc.
  const double turn_per_way = distance > 0 && !is_beside_wall(w, x, y) ? 1 / distance : 0;
  const double vx = s.vx - p.vx[disc], vy = s.vy - p.vy[disc];
  const double stretch_rate = along(nx, ny, vx, vy), half = 0.5 * dt * stretch_rate;
  const double slip_rate = mid_step_slip_rate(across(nx, ny, vx, vy), half, half * turn_per_way,
                                              Arms{distance, 0}, 1, p.spin[disc], 0);
  return {.nx = nx,
          .ny = ny,
          .gap = distance - p.radius[disc] + near.slack,
          .arm_1 = {dx, dy},
          .arm_2 = {0, 0},
          .stretch_rate = stretch_rate,
          .slip_rate = slip_rate};
}

// Seen from the nucleus.
std::array<geometry::Point, 2> WallContacts::ends(const Near& near, const Particles& p) const {
  const MovingWall& w = walls_[near.wall];
  const State& s = states_[near.wall];
  const double x = p.x[near.disc] + p.ux[near.disc], y = p.y[near.disc] + p.uy[near.disc];
  return {{{w.x_1 + s.ux - x, w.y_1 + s.uy - y}, {w.x_2 + s.ux - x, w.y_2 + s.uy - y}}};
}

double WallContacts::depth_in_cell(const Near& near, const FacetSet& facets, const Particles& p) const {
  thread_local std::vector<geometry::Point> corners;
  polygons_.place(near.disc, {0, 0}, facets, corners);
  const auto [from, to] = ends(near, p);
  return largest_depth(from, to, corners);
}

// With the law's stiffness over the side of a regular hexagon per length of the wall, the force is k times
// what pushes, and k times what is stored is stored. A spring bears and stores the same that has the
// stiffness force^2 / 2 energy.
std::optional<Encounter> WallContacts::of_cell(const Near& near, const FacetSet& facets,
                                               const Particles& p) const {
  thread_local std::vector<geometry::Point> corners;
  const std::uint32_t i = near.disc;
  polygons_.place(i, {0, 0}, facets, corners);
  const auto [from, to] = ends(near, p);
  const Depth depth = depth_of(from, to, corners, near.slack);
  if (depth.stored == 0) return std::nullopt;
  const State& s = states_[near.wall];
  const double vx = s.vx - (p.vx[i] - p.spin[i] * depth.y), vy = s.vy - (p.vy[i] + p.spin[i] * depth.x);
  return Encounter{.nx = depth.nx,
                   .ny = depth.ny,
                   .gap = -2 * depth.stored / depth.pushing,
                   .arm_1 = {depth.x, depth.y},
                   .arm_2 = {0, 0},
                   .stretch_rate = along(depth.nx, depth.ny, vx, vy),
                   .slip_rate = across(depth.nx, depth.ny, vx, vy),
                   .stiffening = depth.pushing * depth.pushing / (2 * depth.stored * polygons_.side[i])};
}

std::optional<Encounter> WallContacts::encounter(const Near& near, const FacetSet& facets, const Particles& p,
                                                 double dt) const {
  if (!polygons_.empty()) return of_cell(near, facets, p);
  const Encounter of_disc = this->of_disc(near, p, dt);
  return of_disc.gap < 0 ? std::optional(of_disc) : std::nullopt;
}

void WallContacts::list(const Particles& p) {
  std::vector<Near> fresh;
  auto old = near_.begin();
  for (std::uint32_t w = 0; w < walls_.size(); ++w)
    for (std::uint32_t i = 0; i < p.size(); ++i) {
      const double reach = polygons_.empty() ? p.radius[i] : polygons_.reach[i];
      const PlaneVector at = place(w, i, p), way = to_wall(walls_[w], at.x, at.y);
      if (!p.is_there(i) || !(std::hypot(way.x, way.y) - reach <= skin_)) continue;
      while (old != near_.end() && (old->wall < w || (old->wall == w && old->disc < i))) ++old;
      const bool kept = old != near_.end() && old->wall == w && old->disc == i;
      fresh.push_back(kept ? *old : Near{.wall = w, .disc = i});
    }
  near_ = std::move(fresh);
}

void WallContacts::add_forces(const protocol::Step& step, const FacetSet& facets, Particles& p) {
  const double dt = step.from_rest() ? 0 : step.dt;
  for (State& s : states_) {
    work_ += dt / 2 * (s.fx * s.vx + s.fy * s.vy);
    s.fx = s.fy = 0;
  }
  for (Near& near : near_) {
    const std::uint32_t i = near.disc;
    if (!polygons_.empty() && near.slack > 0)
      near.slack = std::min(near.slack, depth_in_cell(near, facets, p));
    const std::optional<Encounter> meets = encounter(near, facets, p, dt);
    if (!meets && near.touch.stiffness == 0) continue;
    const Encounter now = meets.value_or(Encounter{});
    const LinearContact& of_time = walls_[near.wall].contact;
    const auto [f, loss] = advance(step.relax ? without_dashpots(of_time) : of_time, now,
                                   {p.inverse_mass[i], p.inverse_inertia[i]}, dt, near.touch);
    friction_ += loss.friction;
    dashpots_ += loss.dashpots;
    const PlaneVector force = vector_of(now.nx, now.ny, f.normal, f.shear);
    p.fx[i] += force.x;
    p.fy[i] += force.y;
    p.moment[i] += across(now.arm_1.x, now.arm_1.y, force.x, force.y);
    states_[near.wall].fx += force.x;
    states_[near.wall].fy += force.y;
  }
  for (const State& s : states_) work_ += dt / 2 * (s.fx * s.vx + s.fy * s.vy);
}

double WallContacts::strain_energy() const {
  double sum = 0;
  for (const Near& near : near_) sum += adit::dem::strain_energy(walls_[near.wall].contact, near.touch);
  return sum;
}

}  // namespace adit::dem
