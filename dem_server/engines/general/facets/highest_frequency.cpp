#include "dem_server/engines/general/facets/highest_frequency.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dem_server/engines/general/facets/facets.hpp"
#include "dem_server/model/solid/facets_of_material.hpp"
#include "protocol/motion/random.hpp"

namespace adit::dem {
namespace {

constexpr int kMostRounds = 2000;
constexpr int kTogether = 20;      // rounds between two looks at the growth
constexpr double kStopped = 1e-3;  // growth over these rounds
constexpr double kLacking = 1.02;  // what it may still lack

// Displacements and turns of all cells, and what their forces make of them: x becomes M^-1 K x.
class Oscillation {
 public:
  Oscillation(const Model& model, Masses masses) : masses_(std::move(masses)), facets_(model, 1) {
    particles_ = at_rest(model);
    motion::Random random(1);
    for (auto* column : {&particles_.ux, &particles_.uy, &particles_.spin})
      for (double& value : *column) value = random.uniform() - 0.5;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      particles_.ux[i] *= particles_.radius[i];
      particles_.uy[i] *= particles_.radius[i];
    }
  }

  // Returns x K x / x M x.
  double advance() {
    Particles& p = particles_;
    make_small();
    for (auto* column : {&p.fx, &p.fy, &p.moment}) std::ranges::fill(*column, 0.0);
    facets_.find_linear_forces(p, alone_);
    double twice_strain = 0, square = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      twice_strain -= p.ux[i] * p.fx[i] + p.uy[i] * p.fy[i] + p.spin[i] * p.moment[i];
      square += masses_.mass[i] * (p.ux[i] * p.ux[i] + p.uy[i] * p.uy[i]) +
                masses_.inertia[i] * p.spin[i] * p.spin[i];
      p.ux[i] = -p.fx[i] / masses_.mass[i];
      p.uy[i] = -p.fy[i] / masses_.mass[i];
      p.spin[i] = -p.moment[i] / masses_.inertia[i];
    }
    return twice_strain / square;
  }

 private:
  static constexpr double kSmall = 0x1p-40;  // of a radius: turns are small, so that forces are linear

  void make_small() {
    Particles& p = particles_;
    double largest = 0;  // over the radius
    for (std::size_t i = 0; i < p.size(); ++i)
      largest = std::max(
          {largest, std::abs(p.ux[i]) / p.radius[i], std::abs(p.uy[i]) / p.radius[i], std::abs(p.spin[i])});
    for (auto* column : {&p.ux, &p.uy, &p.spin})
      for (double& value : *column) value *= kSmall / largest;
  }

  Masses masses_;
  Facets facets_;
  Particles particles_;
  protocol::Team alone_;
};

// Without strengths, stresses and weights.
Model elastic(const Model& model) {
  Model plain;
  plain.discs = model.discs;
  plain.mass = model.mass;
  plain.weight.assign(model.discs.size(), 1.0);
  plain.id = model.id;
  plain.group = model.group;
  plain.density = model.density;
  plain.present = model.present;
  plain.gyration_square = model.gyration_square;
  plain.cell_elasticity = model.cell_elasticity;
  plain.cell_stiffness = model.cell_stiffness;
  plain.facets = model.facets;
  plain.facet_laws.assign(model.facet_laws.size(), unbroken());
  for (const Bond& bond : model.bonds)
    if (bond.law == Bond::Law::kFacet)
      plain.bonds.push_back({bond.first, bond.second, bond.law, bond.number});
  std::ranges::sort(plain.bonds, {}, [](const Bond& bond) { return std::pair(bond.first, bond.second); });
  return plain;
}

}  // namespace

double highest_square_of_facets(const Model& model, const Masses& masses) {
  const auto is_facet = [](const Bond& bond) { return bond.law == Bond::Law::kFacet; };
  if (std::ranges::none_of(model.bonds, is_facet)) return 0;
  Oscillation oscillation(elastic(model), masses);
  double before = 0, highest = 0;
  for (int round = 1; round <= kMostRounds; ++round) {
    highest = oscillation.advance();
    if (round % kTogether != 0) continue;
    if (highest <= (1 + kStopped) * before) break;
    before = highest;
  }
  return kLacking * highest;
}

}  // namespace adit::dem
