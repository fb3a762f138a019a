#include "coupler/tunnel/histories.hpp"

#include <utility>

namespace adit::coupler {
namespace {

scene::History& add(scene::Particles& particles, const std::string& name, scene::Quantity quantity) {
  auto& history = *particles.add_histories();
  history.set_name(name);
  history.set_quantity(quantity);
  return history;
}

}  // namespace

// The particle on the inner side has its centre a radius or so outside it.
void add_convergence(const scene::LinedTunnel& tunnel, const Contour& contour, scene::Particles& particles) {
  const auto box = contour.box(tunnel.particles().radius());
  const double x = tunnel.centre().x(), y = tunnel.centre().y();
  const std::pair<const char*, geometry::Point> places[] = {{"crown", {x, box.y_max}},
                                                            {"invert", {x, box.y_min}},
                                                            {"left", {box.x_min, y}},
                                                            {"right", {box.x_max, y}}};
  for (const auto& [part, place] : places)
    for (const scene::Quantity quantity : {scene::DISPLACEMENT_X, scene::DISPLACEMENT_Y}) {
      auto& at = *add(particles, tunnel.name() + "_" + part, quantity).mutable_at();
      at.set_x(place.x);
      at.set_y(place.y);
    }
}

void add_lining_histories(scene::Particles& particles) {
  for (const auto& joint : particles.joints())
    if (joint.has_name())
      for (const scene::Quantity quantity : {scene::OPENING, scene::OFFSET, scene::ROTATION})
        add(particles, joint.name(), quantity).set_joint(joint.name());
  for (const auto& spring : particles.springs())
    if (spring.has_name()) add(particles, spring.name(), scene::SPRING_FORCE).set_spring(spring.name());
  for (const auto& oval : particles.ovals())
    for (const scene::Quantity quantity :
         {scene::LARGEST_DIAMETER_CHANGE, scene::SMALLEST_DIAMETER_CHANGE, scene::LARGEST_DIAMETER_DIRECTION})
      add(particles, oval.name(), quantity).set_oval(oval.name());
  for (const auto& section : particles.sections())
    for (const scene::Quantity quantity : {scene::THRUST, scene::MOMENT, scene::SHEAR_FORCE})
      add(particles, section.name(), quantity).set_section(section.name());
}

}  // namespace adit::coupler
