#include "protocol/sections/fibre_section.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace adit::sections {

namespace {

// Away from bars a crack opens by itself.
ConcreteLaw away_from_bars(ConcreteLaw law, double thickness) {
  law.bonded = 1;
  constexpr double kOpen = 1e-4;  // crack that bears nothing [m]
  if (law.tensile_strength > 0) law.tensile_end = law.tensile_strength / law.modulus + kOpen / thickness;
  return law;
}

// How far the bond of bars reaches from the nearer face: h_c,eff [m].
double effective_height(const BarLayer& bars, const SectionShape& shape, double modular) {
  const double h = shape.thickness, depth = h / 2 + std::abs(bars.position);
  const double steel = modular * bars.area / shape.width;
  const double compressed = -steel + std::sqrt(steel * (steel + 2 * depth));  // x
  return std::min({2.5 * (h - depth), (h - compressed) / 3, h / 2});
}

// `modular`: E_s/E_c.
bool near_bars(double position, const SectionShape& shape, double modular) {
  return std::ranges::any_of(shape.bars, [&](const BarLayer& bars) {
    const double outwards = bars.position < 0 ? -position : position;
    return shape.thickness / 2 - outwards <= effective_height(bars, shape, modular);
  });
}

}  // namespace

FibreSection::FibreSection(const SectionShape& shape, const ConcreteLaw& concrete, const SteelLaw& steel,
                           const std::optional<ConfinedCore>& core, std::size_t layers)
    : shape_(shape), steel_(steel), core_(core) {
  const ConcreteLaw within = core ? core->law : concrete;
  laws_ = {away_from_bars(concrete, shape.thickness), concrete, away_from_bars(within, shape.thickness),
           within};
  const auto add_layer = [&](double position, double area, bool confined) {
    if (area == 0) return;
    layers_.push_back({position, area});
    law_of_.push_back((confined ? 2U : 0U) +
                      (near_bars(position, shape, steel.modulus / concrete.modulus) ? 1U : 0U));
  };
  for (const auto& [position, area] : concrete_layers(shape, layers)) {
    const double share = core && 2 * std::abs(position) < core->height ? core->share : 0;
    add_layer(position, (1 - share) * area, false);
    add_layer(position, share * area, true);
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

bool FibreSection::crushed(double strain, double curvature) const {
  const double height = core_ ? core_->height : shape_.thickness;
  return strain + std::abs(curvature) * height / 2 < -laws_[3].crushed();
}

FibreStates::FibreStates(const FibreSection& section) : steel_(section.shape().bars.size()) {
  for (std::size_t i = 0; i < section.layers().size(); ++i) concrete_.push_back(virgin(section.concrete(i)));
}

SectionForces FibreStates::strain_to(const FibreSection& section, double strain, double curvature) {
  strain_ = strain;
  curvature_ = curvature;
  SectionForces forces{};
  for (std::size_t i = 0; i < concrete_.size(); ++i) {
    const auto [z, area] = section.layers()[i];
    sections::strain_to(section.concrete(i), strain + curvature * z, concrete_[i]);
    const double force = area * concrete_[i].stress;
    forces.thrust += force;
    forces.moment += force * z;
  }
  for (std::size_t i = 0; i < steel_.size(); ++i) {
    const auto& [z, area, diameter] = section.shape().bars[i];
    protocol::strain_to(section.steel(), strain + curvature * z, steel_[i]);
    protocol::break_beyond(section.steel(), strain + curvature * z, steel_[i]);
    const double force = area * steel_[i].stress;
    forces.thrust += force;
    forces.moment += force * z;
  }
  return forces;
}

double FibreStates::stored(const FibreSection& section) const {
  double sum = 0;
  for (std::size_t i = 0; i < concrete_.size(); ++i)
    sum += section.layers()[i].area * sections::stored(concrete_[i]);
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

}  // namespace adit::sections
