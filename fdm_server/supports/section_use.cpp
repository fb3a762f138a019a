#include "fdm_server/supports/section_use.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fdm_server/sections/crack_width.hpp"

namespace adit::fdm {
namespace {

double larger_by_size(double a, double b) {
  return std::abs(b) > std::abs(a) ? b : a;
}

double widest_crack(const LiningSection& section, const FibreStates& states) {
  const auto& [thickness, width, layers] = section.fibres->shape();
  const SteelLaw& steel = section.fibres->steel();
  const double half = states.curvature() * thickness / 2;
  double widest = 0;
  for (const BarLayer& bars : layers) {
    const double strain = states.strain() + states.curvature() * bars.position;
    const double outwards = bars.position > 0 ? 1 : -1;
    const CrackedFace face{thickness,
                           width,
                           bars.area,
                           bars.diameter,
                           section.cover,
                           thickness / 2 + std::abs(bars.position),
                           steel.modulus,
                           section.concrete_modulus,
                           section.tensile_strength};
    widest =
        std::max(widest, crack_width(face, std::min(steel.modulus * strain, steel.yield),
                                     states.strain() + outwards * half, states.strain() - outwards * half));
  }
  return widest;
}

double shear_strength(const Lining& lining, const LiningForces& forces) {
  const LiningSection& section = *lining.section;
  const Bending bending = forces.moment >= 0 ? Bending::kOuterStretched : Bending::kInnerStretched;
  return lining.spacing *
         shear_capacity(section.fibres->shape(), section.shear, bending, forces.thrust / lining.spacing);
}

}  // namespace

double shear_strength(const Lining& lining, const Structures& structures, std::size_t node) {
  if (lining.member)
    if (const auto left = structures.members()[*lining.member].left()) return lining.spacing * *left;
  return shear_strength(lining, forces_at(lining, structures, node));
}

double moment_capacity(const Lining& lining, const Structures& structures, std::size_t node,
                       Bending bending) {
  const double thrust = forces_at(lining, structures, node).thrust / lining.spacing;
  return lining.spacing * lining.section->capacity.moment(bending, thrust);
}

SectionUse section_use(const Lining& lining, const Structures& structures, std::size_t node) {
  const LiningSection& section = *lining.section;
  SectionUse use{};
  const auto [forces, count] = all_forces_at(lining, structures, node);
  for (std::size_t side = 0; side < count; ++side) {
    const auto& [thrust, moment, shear] = forces[side];
    const double utilisation =
        section.capacity.utilisation({thrust / lining.spacing, moment / lining.spacing});
    if (side == 0 || utilisation > use.utilisation) {
      use.utilisation = utilisation;
      use.forces = forces[side];
    }
    use.shear = std::max(use.shear, std::abs(shear) / std::max(shear_strength(lining, forces[side]), 1.0));
  }
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

}  // namespace adit::fdm
