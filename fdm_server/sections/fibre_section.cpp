#include "fdm_server/sections/fibre_section.hpp"

#include <cmath>
#include <span>

namespace adit::fdm {

FibreSection::FibreSection(const SectionShape& shape, const ConcreteLaw& concrete, const SteelLaw& steel,
                           std::size_t layers)
    : shape_(shape),
      concrete_(concrete),
      plain_(concrete),
      near_bars_(layers, false),
      steel_(steel),
      layers_(concrete_layers(shape, layers)) {
  constexpr double kOpen = 1e-4;  // crack that bears nothing [m]
  if (concrete.tensile_strength > 0)
    plain_.tensile_end = concrete.tensile_strength / concrete.modulus + kOpen / shape.thickness;
  for (std::size_t i = 0; i < layers; ++i)
    for (const BarLayer& bars : shape.bars) {
      const double side = bars.position < 0 ? -1 : 1, face = shape.thickness / 2;
      if (face - side * layers_[i].position <= 2.5 * (face - side * bars.position)) near_bars_[i] = true;
    }
  double first = 0, second = 0;
  axial_ = 0;
  const auto add = [&](double modulus, double area, double position) {
    axial_ += modulus * area;
    first += modulus * area * position;
    second += modulus * area * position * position;
  };
  for (const ConcreteLayer& layer : layers_) add(concrete.modulus, layer.area, layer.position);
  for (const BarLayer& bars : shape.bars) add(steel.modulus, bars.area, bars.position);
  centroid_ = first / axial_;
  bending_ = second - first * centroid_;
}

FibreStates::FibreStates(const FibreSection& section)
    : concrete_(section.layers().size(), virgin(section.concrete(0))), steel_(section.shape().bars.size()) {}

SectionForces FibreStates::strain_to(const FibreSection& section, double strain, double curvature) {
  strain_ = strain;
  curvature_ = curvature;
  SectionForces forces{};
  for (std::size_t i = 0; i < concrete_.size(); ++i) {
    const auto [z, area] = section.layers()[i];
    fdm::strain_to(section.concrete(i), strain + curvature * z, concrete_[i]);
    const double force = area * concrete_[i].stress;
    forces.thrust += force;
    forces.moment += force * z;
  }
  for (std::size_t i = 0; i < steel_.size(); ++i) {
    const auto& [z, area, diameter] = section.shape().bars[i];
    protocol::strain_to(section.steel(), strain + curvature * z, steel_[i]);
    const double force = area * steel_[i].stress;
    forces.thrust += force;
    forces.moment += force * z;
  }
  return forces;
}

double FibreStates::stored(const FibreSection& section) const {
  double sum = 0;
  for (std::size_t i = 0; i < concrete_.size(); ++i)
    sum += section.layers()[i].area * fdm::stored(concrete_[i]);
  for (std::size_t i = 0; i < steel_.size(); ++i)
    sum += section.shape().bars[i].area * protocol::stored(section.steel(), steel_[i]);
  return sum;
}

double FibreStates::steel_strain(const FibreSection& section) const {
  double largest = 0;
  for (const BarLayer& bars : section.shape().bars) {
    const double strain = strain_ + curvature_ * bars.position;
    if (std::abs(strain) > std::abs(largest)) largest = strain;
  }
  return largest;
}

void FibreStates::exchange(state::Archive& archive) {
  archive("section_strain", strain_);
  archive("section_curvature", curvature_);
  archive("section_concrete", std::span(concrete_));
  archive("section_steel", std::span(steel_));
}

}  // namespace adit::fdm
