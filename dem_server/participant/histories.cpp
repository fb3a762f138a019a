#include "dem_server/participant/histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

std::uint32_t nearest(const Particles& p, double x, double y) {
  std::uint32_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double dx = p.x[i] - x, dy = p.y[i] - y, squared = dx * dx + dy * dy;
    if (squared < least) {
      least = squared;
      best = static_cast<std::uint32_t>(i);
    }
  }
  return best;
}

double velocity(const Particles& p, scene::Quantity quantity, std::uint32_t i) {
  return quantity == scene::VELOCITY_Y || quantity == scene::ACCELERATION_Y ? p.vy[i] : p.vx[i];
}

}  // namespace

bool is_motion(scene::Quantity quantity) {
  switch (quantity) {
    case scene::DISPLACEMENT_X:
    case scene::DISPLACEMENT_Y:
    case scene::VELOCITY_X:
    case scene::VELOCITY_Y:
    case scene::ACCELERATION_X:
    case scene::ACCELERATION_Y:
      return true;
    default:
      return false;
  }
}

Histories::Histories(const scene::Particles& scene, const Particles& particles,
                     std::span<const double> radius, Others others) {
  for (int i = 0; i < scene.histories_size(); ++i) {
    const auto& history = scene.histories(i);
    if (!is_motion(history.quantity())) {
      if (others == Others::kLeftOut) continue;
      throw protocol::UserError(
          fmt::format("particles.histories[{}].quantity", i),
          fmt::format(
              "is {}, which particles do not have; choose displacement, velocity or acceleration, give "
              "the radius of a circle that a stress is taken over, or ask the continuum",
              protocol::name_of(history.quantity())));
    }
    if (!history.has_at())
      throw protocol::UserError(fmt::format("particles.histories[{}].at", i),
                                "is missing; give the place, {x: …, y: …}");
    const double x = history.at().x(), y = history.at().y();
    const std::uint32_t particle = nearest(particles, x, y);
    if (const double distance = std::hypot(particles.x[particle] - x, particles.y[particle] - y);
        distance > 2 * radius[particle])
      throw protocol::UserError(
          fmt::format("particles.histories[{}].at", i),
          fmt::format("is ({:g}, {:g}) m, but the nearest particle is {:g} m away; choose a "
                      "place within a diameter of a particle",
                      x, y, distance));
    histories_.push_back({history.quantity(), particle, false, {}});
  }
}

void Histories::tie(std::span<const std::uint32_t> particles) {
  for (History& history : histories_)
    history.tied = std::ranges::find(particles, history.particle) != particles.end();
}

void Histories::remember(const Particles& particles) {
  for (History& history : histories_)
    history.velocity.remember(velocity(particles, history.quantity, history.particle));
}

void Histories::read(const Particles& particles, const protocol::Step& step,
                     google::protobuf::RepeatedField<double>& values) const {
  for (const auto& [quantity, i, tied, record] : histories_) {
    switch (quantity) {
      case scene::DISPLACEMENT_X:
        values.Add(particles.ux[i] - particles.settled_x[i]);
        break;
      case scene::DISPLACEMENT_Y:
        values.Add(particles.uy[i] - particles.settled_y[i]);
        break;
      case scene::ACCELERATION_X:
      case scene::ACCELERATION_Y:
        values.Add(record.acceleration(velocity(particles, quantity, i), step, tied));
        break;
      default:
        values.Add(record.before());
    }
  }
}

}  // namespace adit::dem
