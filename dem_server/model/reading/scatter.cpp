#include "dem_server/model/reading/scatter.hpp"

#include "dem_server/model/placement/groups.hpp"
#include "dem_server/packing/meeting_place.hpp"
#include "protocol/scatter/scattering.hpp"

namespace adit::dem {
namespace {

using protocol::Scattering;

ContactBond times(double stiffness, double strength, ContactBond law) {
  law.stiffness.normal *= stiffness;
  law.stiffness.shear *= stiffness;
  law.tensile_strength *= strength;
  law.shear_strength *= strength;
  return law;
}

ParallelBond times(double stiffness, double strength, ParallelBond law) {
  law.normal_stiffness *= stiffness;
  law.shear_stiffness *= stiffness;
  law.tensile_strength *= strength;
  law.cohesion *= strength;
  return law;
}

// The number of a new law, which is so many times the one of this number.
template <class Law>
std::uint32_t add_times(double stiffness, double strength, std::uint32_t number, std::vector<Law>& laws) {
  laws.push_back(times(stiffness, strength, laws[number]));
  return static_cast<std::uint32_t>(laws.size() - 1);
}

class Scatterer {
 public:
  Scatterer(const scene::Particles& particles, Model& model)
      : stiffness_(particles.scatter(), scene::Scatter::STIFFNESS, "particles.scatter"),
        strength_(particles.scatter(), scene::Scatter::STRENGTH, "particles.scatter"),
        model_(model) {}

  void scatter_cells() {
    if (stiffness_.empty() || model_.cell_elasticity.empty()) return;
    for (std::size_t i = 0; i < model_.discs.size(); ++i)
      model_.cell_stiffness.push_back(stiffness_.at(model_.discs.x[i], model_.discs.y[i]));
  }

  // Of a stage, in which each disc is of a group.
  void scatter(const std::vector<std::uint32_t>& group, std::vector<Bond>& bonds) {
    if (stiffness_.empty() && strength_.empty()) return;
    for (Bond& bond : bonds) {
      const auto [x, y] = meeting_place(model_.discs, bond.first, bond.second);
      const double stiffness = stiffness_.at(x, y), strength = strength_.at(x, y);
      if (bond.law == Bond::Law::kContactBond)
        bond.number = add_times(stiffness, strength, bond.number, model_.contact_bonds);
      else if (bond.law == Bond::Law::kParallelBond)
        bond.number = add_times(stiffness, strength, bond.number, model_.parallel_bonds);
      else if (bond.law == Bond::Law::kFacet)
        scatter(strength, group, bond);
    }
  }

 private:
  void scatter(double strength, const std::vector<std::uint32_t>& group, const Bond& bond) {
    FacetBond& facet = model_.facets[bond.number];
    if (!model_.cell_stiffness.empty()) {
      const auto of = [&](std::uint32_t cell) {
        return model_.cell_stiffness[cell] * model_.cell_elasticity[group[cell]].stiffness;
      };
      facet.stiffness = in_series(of(bond.first), of(bond.second)) / (2 * facet.half_distance);
    }
    FacetLaw law = model_.facet_laws[facet.law];
    if (strength_.empty() || !law.breaks()) return;
    law.tensile_strength *= strength;
    law.cohesion *= strength;
    facet.law = static_cast<std::uint32_t>(model_.facet_laws.size());
    model_.facet_laws.push_back(law);
  }

  Scattering stiffness_, strength_;
  Model& model_;
};

}  // namespace

void scatter(const scene::Particles& particles, Model& model) {
  Scatterer scatterer(particles, model);
  scatterer.scatter_cells();
  scatterer.scatter(model.group, model.bonds);
  for (ParticleStage& stage : model.stages) scatterer.scatter(stage.group, stage.bonds);
}

}  // namespace adit::dem
