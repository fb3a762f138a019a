#include "dem_server/histories.hpp"

#include <limits>

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

double value(const Particles& p, scene::Quantity quantity, std::uint32_t i) {
  switch (quantity) {
    case scene::DISPLACEMENT_X:
      return p.ux[i];
    case scene::DISPLACEMENT_Y:
      return p.uy[i];
    case scene::VELOCITY_X:
      return p.vx[i];
    case scene::VELOCITY_Y:
      return p.vy[i];
  }
  return 0;
}

}  // namespace

Histories::Histories(const scene::Particles& scene, const Particles& particles) {
  for (const auto& history : scene.histories())
    histories_.push_back({history.quantity(), nearest(particles, history.at().x(), history.at().y())});
}

void Histories::read(const Particles& particles, google::protobuf::RepeatedField<double>& values) const {
  values.Clear();
  for (const History& history : histories_) values.Add(value(particles, history.quantity, history.particle));
}

}  // namespace adit::dem
