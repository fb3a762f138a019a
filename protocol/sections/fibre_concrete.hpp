// Concrete with fibres: residual tensile strengths from those of notched beams (EN 14651), by the fib Model
// Code 2010, 5.6.4.
//
// f_R1, f_R3 at crack mouth openings of 0.5 and 2.5 mm. Linear model (eqs. 5.6-5, 5.6-6):
//   f_Fts = 0.45 f_R1,   f_Ftu = f_Fts - w_u/2.5 mm (f_Fts - 0.5 f_R3 + 0.2 f_R1) >= 0
// Rigid-plastic model (eq. 5.6-4): f_Ftu = f_R3 / 3 at every opening.
// An opening is a strain over the structural length l_cs (5.6.5); in a section without bars in tension it is
// the thickness. The ultimate opening is w_u = min(2.5 mm, 0.02 l_cs): 2 % of strain that varies over the
// section.
#pragma once

#include <algorithm>

#include "protocol/sections/concrete_law.hpp"

namespace adit::sections {

struct ResidualStrengths {
  double first, third;  // f_R1, f_R3 [Pa]
};

inline ResidualTension linear_model(const ResidualStrengths& of, double structural_length) {
  constexpr double kThirdOpening = 2.5e-3;  // CMOD_3 [m]
  const double opening = std::min(kThirdOpening, 0.02 * structural_length), service = 0.45 * of.first;
  const double ultimate = service - opening / kThirdOpening * (service - 0.5 * of.third + 0.2 * of.first);
  return {service, std::max(ultimate, 0.0), opening / structural_length};
}

inline ResidualTension rigid_plastic_model(const ResidualStrengths& of, double structural_length) {
  return {of.third / 3, of.third / 3, std::min(2.5e-3, 0.02 * structural_length) / structural_length};
}

}  // namespace adit::sections
