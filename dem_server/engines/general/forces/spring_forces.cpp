#include "dem_server/engines/general/forces/spring_forces.hpp"

#include <algorithm>
#include <cmath>

#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/laws/spring.hpp"

namespace adit::dem {
namespace {

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
      whole_(springs_.size()),
      installed_at_(springs_.size(), 0.0) {
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    whole_[k] = springs_[k].stage == 0;
    forces_[k] = whole_[k] ? springs_[k].pretension : 0;
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
      forces_[k] = spring.pretension;
      installed_at_[k] = shape_of(spring, p).elongation;
    }
  }
}

void SpringForces::add_forces(double dt, Particles& p) {
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    if (!whole_[k]) continue;
    const Spring& spring = springs_[k];
    const std::uint32_t i = spring.first, j = spring.second;
    const auto [dx, dy, length, elongation] = shape_of(spring, p);
    const double force = spring.pretension + spring.stiffness * (elongation - installed_at_[k]);
    forces_[k] = spring.tension_only ? std::max(force, 0.0) : force;
    if (forces_[k] > spring.strength) {
      const double stretch = dt * along(dx, dy, p.vx[j] - p.vx[i], p.vy[j] - p.vy[i]) / length;
      released_ += released_energy(force, spring.stiffness, stretch);
      forces_[k] = 0;
      whole_[k] = false;
      ++broken_;
      continue;
    }
    const double fx = forces_[k] * dx / length, fy = forces_[k] * dy / length;
    p.fx[i] += fx;
    p.fy[i] += fy;
    p.fx[j] -= fx;
    p.fy[j] -= fy;
  }
}

double SpringForces::strain_energy() const {
  double sum = 0;
  for (std::size_t k = 0; k < springs_.size(); ++k) sum += spring_energy(forces_[k], springs_[k].stiffness);
  return sum;
}

}  // namespace adit::dem
