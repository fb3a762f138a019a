#include "dem_server/motion.hpp"

#include <span>

namespace adit::dem {
namespace {

void add_product(double dt, std::span<const double> rate, std::span<double> value) {
  for (std::size_t i = 0; i < value.size(); ++i) value[i] += dt * rate[i];
}

void add_product(double dt, std::span<const double> force, std::span<const double> inverse_mass,
                 std::span<double> velocity) {
  for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] += dt * force[i] * inverse_mass[i];
}

}  // namespace

void move(double dt, Particles& p) {
  add_product(dt, p.vx, p.ux);
  add_product(dt, p.vy, p.uy);
}

void kick(double dt, Particles& p) {
  add_product(dt, p.fx, p.inverse_mass, p.vx);
  add_product(dt, p.fy, p.inverse_mass, p.vy);
  add_product(dt, p.moment, p.inverse_inertia, p.spin);
}

}  // namespace adit::dem
