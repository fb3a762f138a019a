// Concrete inside stirrups (Mander, Priestley & Park 1988, J. Struct. Eng. 114).
//
// The pressure of stirrups of the ratio rho in each of the two directions across the axis, which confine by
// k_e, is f_l = k_e rho f_yh; with it
//   f_cc = f_c (-1.254 + 2.254 sqrt(1 + 7.94 f_l/f_c) - 2 f_l/f_c),
//   eps_cc = eps_c1 (1 + 5 (f_cc/f_c - 1)),
// and the first stirrup breaks at the strain (Paulay & Priestley 1992, eq. 3.12)
//   eps_cu = 0.004 + 1.4 (2 rho) f_yh eps_sm / f_cc,
// eps_sm being the limit strain of the steel.
#pragma once

#include <cmath>

#include "protocol/materials/read_steel.hpp"
#include "protocol/sections/concrete_law.hpp"

namespace adit::sections {

struct Confinement {
  double ratio, effectiveness;  // rho, k_e
};

inline ConcreteLaw confined(const ConcreteLaw& plain, const protocol::SteelValues& steel,
                            const Confinement& by) {
  const double yields = by.ratio * steel.yield, pressure = by.effectiveness * yields / plain.strength;
  const double gain = -1.254 + 2.254 * std::sqrt(1 + 7.94 * pressure) - 2 * pressure;
  ConcreteLaw law = plain;
  law.strength = gain * plain.strength;
  law.peak_strain = plain.peak_strain * (1 + 5 * (gain - 1));
  law.stirrups_break = 0.004 + 1.4 * 2 * yields * steel.limit_strain / law.strength;
  return law;
}

}  // namespace adit::sections
