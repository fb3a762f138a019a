#include "dem_server/engines/general/forces/spring_forces.hpp"

#include <algorithm>
#include <cmath>

#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/laws/spring.hpp"

namespace adit::dem {
namespace {

double beyond(double clearance, double opening) {
  return clearance > 0 ? std::copysign(std::max(0.0, std::abs(opening) - clearance), opening) : opening;
}

// Without regard to what the spring cannot bear.
double force_at(const Spring& spring, double opening) {
  const double stretch = beyond(spring.clearance, opening);
  return spring.curve ? spring.curve->force(stretch) : spring.pretension + spring.stiffness * stretch;
}

double energy_at(const Spring& spring, double opening, double force) {
  return spring.curve ? spring.curve->energy(beyond(spring.clearance, opening))
                      : spring_energy(force, spring.stiffness);
}

struct SpringShape {
  double dx, dy, length, elongation;  // from the first to the second centre, as they are now [m]
};

SpringShape shape_of(const Spring& spring, const Particles& p) {
  const std::uint32_t i = spring.first, j = spring.second;
  const double rest_x = p.x[j] - p.x[i], rest_y = p.y[j] - p.y[i];
  const double ux = p.ux[j] - p.ux[i], uy = p.uy[j] - p.uy[i], dx = rest_x + ux, dy = rest_y + uy;
  const double length = std::hypot(dx, dy);
  return {dx, dy, length,
          growth_of_square(rest_x, rest_y, dx, dy, ux, uy) / (length + std::hypot(rest_x, rest_y))};
}

}  // namespace

SpringForces::SpringForces(std::vector<Spring> springs)
    : springs_(std::move(springs)),
      forces_(springs_.size()),
      openings_(springs_.size()),
      whole_(springs_.size()),
      installed_at_(springs_.size(), 0.0) {
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    whole_[k] = springs_[k].stage == 0;
    forces_[k] = whole_[k] ? force_at(springs_[k], 0) : 0;
  }
}

void SpringForces::begin_stage(std::uint32_t before, std::uint32_t stage, const Particles& p) {
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    const Spring& spring = springs_[k];
    if (!p.is_there(spring.first) || !p.is_there(spring.second)) {
      whole_[k] = false;
      forces_[k] = 0;
    } else if (spring.stage > before && spring.stage <= stage) {
      whole_[k] = true;
      forces_[k] = force_at(spring, 0);
      openings_[k] = 0;
      installed_at_[k] = shape_of(spring, p).elongation;
    }
  }
}

void SpringForces::add_forces(double dt, Particles& p) {
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    if (!whole_[k]) continue;
    if (springs_[k].direction)
      pull_in_direction(k, dt, p);
    else
      pull_along_line(k, dt, p);
  }
}

void SpringForces::pull_along_line(std::size_t k, double dt, Particles& p) {
  const std::uint32_t i = springs_[k].first, j = springs_[k].second;
  const auto [dx, dy, length, elongation] = shape_of(springs_[k], p);
  const double stretch = dt * along(dx, dy, p.vx[j] - p.vx[i], p.vy[j] - p.vy[i]) / length;
  if (!holds(k, elongation - installed_at_[k], stretch)) return;
  const double fx = forces_[k] * dx / length, fy = forces_[k] * dy / length;
  p.fx[i] += fx;
  p.fy[i] += fy;
  p.fx[j] -= fx;
  p.fy[j] -= fy;
}

void SpringForces::pull_in_direction(std::size_t k, double dt, Particles& p) {
  const std::uint32_t i = springs_[k].first, j = springs_[k].second;
  const auto [nx, ny] = *springs_[k].direction;
  const double dx = (p.x[j] - p.x[i]) + (p.ux[j] - p.ux[i]), dy = (p.y[j] - p.y[i]) + (p.uy[j] - p.uy[i]);
  const double length = std::hypot(dx, dy), ex = dx / length, ey = dy / length;
  const Arms arms = arms_of(length, (p.radius[i] - p.radius[j]) / 2);
  const double rolling = rolling_speed(arms, p.spin[i], p.spin[j]);
  const double stretch =
      dt * along(nx, ny, p.vx[j] - p.vx[i] + rolling * ey, p.vy[j] - p.vy[i] - rolling * ex);
  if (!holds(k, openings_[k] + stretch, stretch)) return;
  const double fx = forces_[k] * nx, fy = forces_[k] * ny, turning = across(ex, ey, fx, fy);
  p.fx[i] += fx;
  p.fy[i] += fy;
  p.moment[i] += arms.first * turning;
  p.fx[j] -= fx;
  p.fy[j] -= fy;
  p.moment[j] += arms.second * turning;
}

bool SpringForces::holds(std::size_t k, double opening, double stretch) {
  const Spring& spring = springs_[k];
  const double before = openings_[k], force_before = forces_[k], force = force_at(spring, opening);
  openings_[k] = opening;
  forces_[k] = spring.tension_only ? std::max(force, 0.0) : force;
  if (!(forces_[k] > spring.strength)) return true;
  // In the scheme's own form: what was stored, and the first half of the step's trapezoid.
  released_ += spring.curve ? energy_at(spring, before, force_before) + force_before * stretch / 2
                            : released_energy(force, spring.stiffness, stretch);
  forces_[k] = 0;
  whole_[k] = false;
  broken_.push_back(static_cast<std::uint32_t>(k));
  return false;
}

// Three pieces by clearance: closed, free, open; each with those of the curve, or taut and slack.
std::size_t SpringForces::piece(std::size_t k) const {
  const Spring& spring = springs_[k];
  const double stretch = beyond(spring.clearance, openings_[k]);
  const std::size_t by_clearance = spring.clearance > 0 && stretch != 0 ? (stretch > 0 ? 2 : 1) : 0;
  std::size_t by_force = 0;
  if (spring.curve)
    by_force = spring.curve->segment(stretch);
  else if (spring.tension_only)
    by_force = force_at(spring, openings_[k]) > 0 ? 1 : 0;
  return 3 * by_force + by_clearance;
}

double SpringForces::strain_energy() const {
  double sum = 0;
  for (std::size_t k = 0; k < springs_.size(); ++k)
    if (whole_[k]) sum += energy_at(springs_[k], openings_[k], forces_[k]);
  return sum;
}

}  // namespace adit::dem
