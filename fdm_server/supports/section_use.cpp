#include "fdm_server/supports/section_use.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "protocol/sections/crack_width.hpp"

namespace adit::fdm {
namespace {

double larger_by_size(double a, double b) {
  return std::abs(b) > std::abs(a) ? b : a;
}

double widest_crack(const LiningSection& section, const sections::FibreStates& states) {
  const auto& [thickness, width, layers] = section.fibres->shape();
  const protocol::SteelLaw& steel = section.fibres->steel();
  const double half = states.curvature() * thickness / 2;
  double widest = 0;
  for (const sections::BarLayer& bars : layers) {
    const double strain = states.strain() + states.curvature() * bars.position;
    const double outwards = bars.position > 0 ? 1 : -1;
    const sections::CrackedFace face{thickness,
                                     width,
                                     bars.area,
                                     bars.diameter,
                                     section.cover,
                                     thickness / 2 + std::abs(bars.position),
                                     steel.modulus,
                                     section.concrete_modulus,
                                     section.tensile_strength};
    widest = std::max(
        widest, sections::crack_width(face, std::min(steel.modulus * strain, steel.yield),
                                      states.strain() + outwards * half, states.strain() - outwards * half));
  }
  return widest;
}

// Of one metre, whose forces are those of a member over its spacing.
sections::Use use_of_metre(const Lining& lining, const LiningForces& forces) {
  return sections::use_of(lining.section->strength,
                          {forces.thrust / lining.spacing, forces.moment / lining.spacing},
                          forces.shear / lining.spacing);
}

// At each node.
std::vector<double> hinge_rotations(const Lining& lining, const Structures& structures) {
  std::vector<double> at_nodes(lining.path.points.size(), 0.0);
  const protocol::SteelLaw& steel = lining.section->fibres->steel();
  const double yields = steel.yield / steel.modulus;
  std::vector<double> turns;  // of the sections of fibres, two a beam
  for (std::uint32_t beam = 0; beam < lining.beams; ++beam) {
    const FibreBeam& fibres = *structures.fibres(lining.first_beam + beam);
    const double half = structures.beams()[lining.first_beam + beam].chord().length / 2;
    for (const std::size_t end : {0, 1}) {
      const double strain = std::abs(fibres.states(end).steel_strain(fibres.section()));
      const double beyond = strain > yields ? 1 - yields / strain : 0;
      turns.push_back(half * beyond * fibres.states(end).curvature());
    }
  }
  const auto joins = [&](std::size_t a, std::size_t b) { return turns[a] * turns[b] > 0; };
  const std::size_t count = turns.size();
  std::vector<double> hinges(count, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const bool begins = k == 0 ? !lining.path.closed || !joins(count - 1, 0) : !joins(k - 1, k);
    if (!begins || turns[k] == 0) continue;
    std::vector<std::size_t> hinge{k};
    double sum = turns[k];
    while (hinge.size() < count && (hinge.back() + 1 < count || lining.path.closed) &&
           joins(hinge.back(), (hinge.back() + 1) % count)) {
      hinge.push_back((hinge.back() + 1) % count);
      sum += turns[hinge.back()];
    }
    for (const std::size_t section : hinge) hinges[section] = sum;
  }
  // The nodes at both ends of a section's beam.
  for (std::size_t k = 0; k < count; ++k)
    for (const std::size_t node : {k / 2, (k / 2 + 1) % at_nodes.size()})
      if (std::abs(hinges[k]) > std::abs(at_nodes[node])) at_nodes[node] = hinges[k];
  return at_nodes;
}

}  // namespace

double shear_strength(const Lining& lining, const Structures& structures, std::size_t node) {
  if (lining.member)
    if (const auto left = structures.members()[*lining.member].left()) return lining.spacing * *left;
  return lining.spacing * use_of_metre(lining, forces_at(lining, structures, node)).shear_strength;
}

double moment_capacity(const Lining& lining, const Structures& structures, std::size_t node,
                       sections::Bending bending) {
  const double thrust = forces_at(lining, structures, node).thrust / lining.spacing;
  return lining.spacing * lining.section->strength.capacity.moment(bending, thrust);
}

SectionUse section_use(const Lining& lining, const Structures& structures, std::size_t node) {
  const LiningSection& section = *lining.section;
  SectionUse use{};
  const auto [forces, count] = all_forces_at(lining, structures, node);
  for (std::size_t side = 0; side < count; ++side) {
    const sections::Use now = use_of_metre(lining, forces[side]);
    if (side == 0 || now.utilisation > use.utilisation) {
      use.utilisation = now.utilisation;
      use.forces = forces[side];
    }
    use.shear = std::max(use.shear, now.shear);
    use.moment_ratio = std::max(use.moment_ratio, now.moment_ratio);
  }
  if (section.elastic) return use;
  const auto take = [&](std::size_t beam, std::size_t end) {
    const FibreBeam& fibres = *structures.fibres(lining.first_beam + beam);
    use.curvature = larger_by_size(use.curvature, fibres.curvature(end));
    use.steel_strain = larger_by_size(use.steel_strain, fibres.states(end).steel_strain(fibres.section()));
    use.crack_width = std::max(use.crack_width, widest_crack(section, fibres.states(end)));
  };
  if (lining.path.closed || node > 0) take((node + lining.beams - 1) % lining.beams, 1);
  if (lining.path.closed || node < lining.beams) take(node % lining.beams, 0);
  return use;
}

std::vector<SectionUse> section_uses(const Lining& lining, const Structures& structures) {
  std::vector<SectionUse> uses(lining.path.points.size(), SectionUse{});
  if (!lining.section) return uses;
  for (std::size_t node = 0; node < uses.size(); ++node) uses[node] = section_use(lining, structures, node);
  if (lining.section->elastic) return uses;
  const std::vector<double> hinges = hinge_rotations(lining, structures);
  for (std::size_t node = 0; node < uses.size(); ++node) uses[node].hinge_rotation = hinges[node];
  return uses;
}

}  // namespace adit::fdm
