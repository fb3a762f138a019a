#include "dem_server/motion.hpp"

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

void move(double dt, std::span<const protocol::Stretch> some, Particles& p) {
  for (const protocol::Stretch& stretch : some) {
    const auto part = [&](auto& values) {
      return std::span(values).subspan(stretch.begin, stretch.end - stretch.begin);
    };
    add_product(dt, part(p.vx), part(p.ux));
    add_product(dt, part(p.vy), part(p.uy));
  }
}

void kick(double dt, std::span<const protocol::Stretch> some, Particles& p) {
  for (const protocol::Stretch& stretch : some) {
    const auto part = [&](auto& values) {
      return std::span(values).subspan(stretch.begin, stretch.end - stretch.begin);
    };
    add_product(dt, part(p.fx), part(p.inverse_mass), part(p.vx));
    add_product(dt, part(p.fy), part(p.inverse_mass), part(p.vy));
    add_product(dt, part(p.moment), part(p.inverse_inertia), part(p.spin));
  }
}

}  // namespace adit::dem
