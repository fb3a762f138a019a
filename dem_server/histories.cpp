#include "dem_server/histories.hpp"

#include <fmt/format.h>

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

double value(const Particles& p, const Velocities& before, scene::Quantity quantity, std::uint32_t i) {
  switch (quantity) {
    case scene::DISPLACEMENT_X:
      return p.ux[i] - p.settled_x[i];
    case scene::DISPLACEMENT_Y:
      return p.uy[i] - p.settled_y[i];
    case scene::VELOCITY_X:
      return before.x[i];
    case scene::VELOCITY_Y:
      return before.y[i];
    default:
      return 0;
  }
}

}  // namespace

Histories::Histories(const scene::Particles& scene, const Particles& particles) {
  const double reach = 2 * scene.packing().radius();
  for (int i = 0; i < scene.histories_size(); ++i) {
    const auto& history = scene.histories(i);
    const double x = history.at().x(), y = history.at().y();
    if (history.quantity() > scene::VELOCITY_Y)
      throw protocol::UserError(fmt::format("particles.histories[{}].quantity", i),
                                "is none that particles have; choose displacement or velocity");
    const std::uint32_t particle = nearest(particles, x, y);
    if (const double distance = std::hypot(particles.x[particle] - x, particles.y[particle] - y);
        distance > reach)
      throw protocol::UserError(
          fmt::format("particles.histories[{}].at", i),
          fmt::format("is ({:g}, {:g}) m, but the nearest particle is {:g} m away; choose a "
                      "place within a diameter of a particle",
                      x, y, distance));
    histories_.push_back({history.quantity(), particle});
  }
}

void Histories::read(const Particles& particles, const Velocities& before,
                     google::protobuf::RepeatedField<double>& values) const {
  values.Clear();
  for (const History& history : histories_)
    values.Add(value(particles, before, history.quantity, history.particle));
}

}  // namespace adit::dem
