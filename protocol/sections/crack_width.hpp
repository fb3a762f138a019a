// The width of cracks in service: EN 1992-1-1:2004, 7.3.4, of bars with good bond.
//
//   w_k = s_r,max (eps_sm - eps_cm)                                                              (7.8)
//   eps_sm - eps_cm = (sigma_s - k_t f_ct,eff/rho (1 + alpha_e rho)) / E_s >= 0.6 sigma_s/E_s     (7.9)
//   s_r,max = 3.4 c + 0.425 k_1 k_2 phi/rho,   k_1 = 0.8,   k_2 = (eps_1 + eps_2)/(2 eps_1)      (7.11, 7.13)
//   s_r,max = 1.3 (h - x) where bars are farther apart than 5 (c + phi/2)                        (7.14)
//   rho = A_s/A_c,eff,   h_c,eff = min(2.5 (h - d), (h - x)/3, h/2)                              (7.3.2 (3))
// x is the depth of the neutral axis, eps_1 and eps_2 the larger and the smaller tensile strain of the faces
// (0 where compressed). Where the whole section is in tension x counts as 0 and h_c,eff is at most h/2.
// k_t = 0.6: loads of short duration. Below the cracking strain f_ct/E_cm at the face there is no crack.
#pragma once

#include <algorithm>

namespace adit::sections {

struct CrackedFace {
  double thickness, width;            // h, b [m]
  double area, diameter, cover;       // A_s [m^2], phi [m], c [m]
  double depth;                       // d [m]
  double steel_modulus;               // E_s [Pa]
  double concrete_modulus, strength;  // E_cm, f_ct,eff [Pa]
};

// `stress`: of the bars [Pa]; `near`, `far`: strains at the face beside them and at the other one.
inline double crack_width(const CrackedFace& of, double stress, double near, double far,
                          double duration_factor = 0.6) {
  if (stress <= 0 || near <= of.strength / of.concrete_modulus) return 0;
  const double tensioned = far >= 0 ? of.thickness : of.thickness * near / (near - far);  // h - x
  const double effective = std::min({2.5 * (of.thickness - of.depth), tensioned / 3, of.thickness / 2});
  const double ratio = of.area / (of.width * effective), modular = of.steel_modulus / of.concrete_modulus;
  const double spacing_of_bars = of.width * 0.7853981633974483 * of.diameter * of.diameter / of.area;
  const double distribution = (near + std::max(far, 0.0)) / (2 * std::max(near, far));
  const double spacing = spacing_of_bars > 5 * (of.cover + of.diameter / 2)
                             ? 1.3 * tensioned
                             : 3.4 * of.cover + 0.425 * 0.8 * distribution * of.diameter / ratio;
  const double bond = duration_factor * of.strength / ratio * (1 + modular * ratio);
  return spacing * std::max(stress - bond, 0.6 * stress) / of.steel_modulus;
}

}  // namespace adit::sections
