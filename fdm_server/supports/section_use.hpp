// How far a lining's reinforced sections are used at a node.
#pragma once

#include <cstddef>
#include <vector>

#include "fdm_server/supports/lining.hpp"

namespace adit::fdm {

struct SectionUse {
  LiningForces forces;  // those for which the utilisation is larger, where the node is a corner
  double utilisation;   // of thrust and moment (capacity.hpp)
  double shear;         // shear force over what the section resists with this thrust
  double moment_ratio;  // of the moment to the ultimate one with its thrust, by size
  // Of fibres; 0 of a section that stays elastic.
  double curvature;     // [1/m]; the larger by size of the beams that meet
  double steel_strain;  // likewise, of all bars at the nearest sections
  double crack_width;   // [m], the largest by the present strains (crack_width.hpp)
  // The rotation of the plastic hinge that reaches the node, with the sign of its moment [rad]. A hinge goes
  // over all sections of fibres that follow one another and yield in one sense; its rotation is the sum of
  // their lengths times kappa (1 - eps_y/eps_s), the curvature beyond that at which the most strained bar
  // yields. Known to section_uses() alone.
  double hinge_rotation;
};

// Of a lining that has a section. Thrust, moment and shear force are those at the node, curvatures those of
// the ends of its beams, strains those at the nearest sections of fibres.
SectionUse section_use(const Lining& lining, const Structures& structures, std::size_t node);
// Of all its nodes; 0 of a lining without a section.
std::vector<SectionUse> section_uses(const Lining& lining, const Structures& structures);
// The shear force that its section resists with the thrust there, or what is left of it where the member has
// failed [N].
double shear_strength(const Lining& lining, const Structures& structures, std::size_t node);
// The ultimate moment with the thrust there [N m].
double moment_capacity(const Lining& lining, const Structures& structures, std::size_t node,
                       sections::Bending bending);

}  // namespace adit::fdm
