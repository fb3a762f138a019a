// What observers see of the general engine (observe/observable.hpp).
#include <algorithm>
#include <cmath>
#include <optional>

#include "dem_server/engines/general/general_engine.hpp"

namespace adit::dem {
namespace {

ObservedPair forces_of(std::uint32_t pair, const Solver& solver, const Pairs& pairs) {
  const PairState s = state_of(pair, solver.laws(), solver.particles(), pairs);
  return {pairs.first[pair],
          pairs.second[pair],
          s.nx,
          s.ny,
          s.bond_normal + s.contact_normal,
          s.shear,
          s.moment,
          pairs.weight[pair],
          pairs.bonded() ? pairs.state[pair] : BondState::kIntact,
          s.touches,
          solver.laws()[pairs.law[pair]].km > 0};
}

// Of the larger of its two points, which bear half of the facet each and its moment together.
std::optional<double> demand_of(std::uint32_t facet, const FacetState& state, const FacetSet& set) {
  const FacetLaw& law = set.laws[set.law[facet]];
  if (!law.breaks()) return std::nullopt;
  if (set.worn_facet(facet) != nullptr) return 1;
  const double length = set.length[facet], normal = state.normal / length, shear = state.shear / length;
  const double bending = state.moment / (kFacetPoint * length * length);
  return std::max(facet_demand(law, {normal + bending, shear}), facet_demand(law, {normal - bending, shear}));
}

ObservedPair forces_of(std::uint32_t facet, const Solver& solver) {
  const FacetSet& set = solver.facets().set();
  const FacetState s = solver.facets().state(facet, solver.particles());
  return {.first = set.first[facet],
          .second = set.second[facet],
          .nx = s.nx,
          .ny = s.ny,
          .normal = s.normal,
          .shear = s.shear,
          .moment = s.moment,
          .weight = set.weight[facet],
          .state = s.state,
          .touches = s.state == BondState::kIntact || s.normal < 0,
          .resists_turning = true,
          .place = PlaneVector{s.x, s.y},
          .opening = s.opening,
          .slip = s.slip,
          .demand = demand_of(facet, s, set)};
}

ObservedCrack crack_of(std::uint32_t facet, const Facets& facets, const Particles& particles) {
  const Crack crack = facets.crack(facet, particles);
  const FacetState state = facets.state(facet, particles);
  const double half = crack.length / 2;
  const double x = half * std::cos(crack.orientation), y = half * std::sin(crack.orientation);
  return {facets.set().first[facet],
          facets.set().second[facet],
          crack.x - x,
          crack.y - y,
          crack.x + x,
          crack.y + y,
          std::min(state.opening, half),
          std::clamp(state.slip, -half, half),
          state.state};
}

}  // namespace

// Facets come after the bonds of discs.
void GeneralEngine::for_each_bond(const SeePair& see) const {
  for (std::uint32_t k = 0; k < solver_.bonds().size(); ++k) see(forces_of(k, solver_, solver_.bonds()));
  for (const std::uint32_t k : solver_.facets().joining()) see_facet(k, see);
}

void GeneralEngine::see_facet(std::uint32_t facet, const SeePair& see) const {
  see(forces_of(facet, solver_));
}

void GeneralEngine::see_bonds(std::span<const std::uint32_t> bonds, const SeePair& see) const {
  const auto pairs = static_cast<std::uint32_t>(solver_.bonds().size());
  for (const std::uint32_t k : bonds)
    see(k < pairs ? forces_of(k, solver_, solver_.bonds())
                  : forces_of(solver_.facets().joining()[k - pairs], solver_));
}

void GeneralEngine::for_each_contact(const SeePair& see) const {
  for (std::uint32_t k = 0; k < solver_.contacts().size(); ++k)
    if (const ObservedPair contact = forces_of(k, solver_, solver_.contacts()); contact.touches) see(contact);
  for (const std::uint32_t k : solver_.facets().touching())
    if (const ObservedPair contact = forces_of(k, solver_); contact.normal < 0) see(contact);
  const Particles& p = particles();
  for (const CellContacts::Contact& contact : solver_.cells().contacts())
    if (const auto meets = solver_.cells().encounter(contact, solver_.facets().set(), p))
      see({.first = contact.first,
           .second = contact.second,
           .nx = meets->nx,
           .ny = meets->ny,
           .normal = contact.touch.normal - contact.touch.dashpots.normal,
           .shear = contact.touch.shear,
           .moment = 0,
           .weight = solver_.cells().weight(contact, p),
           .place = PlaneVector{p.x[contact.first] + p.ux[contact.first] + meets->arm_1.x,
                                p.y[contact.first] + p.uy[contact.first] + meets->arm_1.y}});
}

std::vector<ObservedCrack> GeneralEngine::cracks() const {
  std::vector<ObservedCrack> cracks;
  const Facets& facets = solver_.facets();
  const FacetSet& set = facets.set();
  for (const auto& block : set.worn)
    for (const WornFacet& worn : block)
      if (worn.cracked && set.laws[set.law[worn.facet]].joined) {
        cracks.push_back(crack_of(worn.facet, facets, particles()));
        cracks.back().debonded = model_.group[cracks.back().first] != model_.group[cracks.back().second];
      }
  return cracks;
}

std::vector<JointForce> GeneralEngine::joints() const {
  std::vector<JointForce> joints;
  for (const Joints::Joint& j : solver_.joints().joints()) {
    const PlaneVector force = vector_of(j.nx, j.ny, j.normal, j.springs.shear);
    joints.push_back(
        {j.first, j.second, force.x, force.y, j.normal, j.springs.shear, j.slip, j.displacement});
  }
  return joints;
}

std::vector<WallTouch> GeneralEngine::wall_touches() const {
  const Particles& p = particles();
  std::vector<WallTouch> touches;
  for (const WallContacts::Near& near : solver_.walls().near()) {
    const auto meets = solver_.walls().encounter(near, solver_.facets().set(), p);
    if (!meets) continue;
    const double x = p.x[near.disc] + p.ux[near.disc], y = p.y[near.disc] + p.uy[near.disc];
    const PlaneVector force =
        vector_of(meets->nx, meets->ny, near.touch.normal - near.touch.dashpots.normal, near.touch.shear);
    touches.push_back({near.disc, x + meets->arm_1.x, y + meets->arm_1.y, force.x, force.y});
  }
  return touches;
}

std::vector<SpringForce> GeneralEngine::springs() const {
  const SpringForces& all = solver_.springs();
  std::vector<SpringForce> springs;
  for (const Spring& spring : all.springs()) {
    const std::size_t k = springs.size();
    springs.push_back({spring.first, spring.second, all.forces()[k], all.openings()[k], false,
                       spring.direction, spring.name});
  }
  for (const std::uint32_t k : all.broken()) springs[k].broken = true;
  return springs;
}

std::vector<ObservedBar> GeneralEngine::bars() const {
  std::vector<ObservedBar> observed;
  const Bars& bars = solver_.bars();
  for (std::uint32_t b = 0; b < bars.size(); ++b) {
    const BarChain& chain = bars.chain(b);
    const Bar& bar = chain.bar();
    for (std::size_t k = 0; k < bar.elements(); ++k) {
      const std::size_t after = bar.after(k);
      const BarNode &one = bar.nodes[k], &other = bar.nodes[after];
      const BarElement e = bars.element(b, k, particles());
      observed.push_back({b,
                          bars.installed(b) && chain.whole(k),
                          e.first,
                          e.second,
                          one.x,
                          one.y,
                          other.x,
                          other.y,
                          e.nx,
                          e.ny,
                          (e.x_1 + e.x_2) / 2,
                          (e.y_1 + e.y_2) / 2,
                          e.pull,
                          e.dowel,
                          chain.stress(k),
                          chain.strain(k),
                          chain.slip(k),
                          chain.slip(after),
                          chain.bond_stress(k),
                          chain.bond_stress(after)});
    }
  }
  return observed;
}

std::vector<WallForce> GeneralEngine::walls() const {
  std::vector<WallForce> walls;
  for (const MovingWall& wall : solver_.walls().walls()) {
    const auto [x, y] = solver_.walls().force(walls.size());
    walls.push_back({wall.name, x, y});
  }
  return walls;
}

}  // namespace adit::dem
