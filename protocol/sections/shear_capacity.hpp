// The shear force that a section resists: EN 1992-1-1:2004, 6.2.2 and 6.2.3.
//
// Without stirrups (eqs. 6.2 a and b, f in MPa, d in mm):
//   V_Rd,c = (max(0.18/gamma_c k (100 rho_l f)^(1/3), v_min) + 0.15 sigma_cp) b d
//   k = 1 + sqrt(200/d) <= 2,   rho_l = A_sl/(b d) <= 0.02,   v_min = 0.0525/gamma_c k^(3/2) f^(1/2)
//   sigma_cp = -N/A_c < 0.2 f_cd
// v_min is the code's 0.035 k^(3/2) f^(1/2) for gamma_c = 1.5. With stirrups at right angles to the axis the
// larger of this and of eqs. 6.8 and 6.9:
//   V_Rd,s = A_sw/s z f_ywd cot theta,   V_Rd,max = b z nu_1 f_cd / (cot theta + tan theta)
//   nu_1 = 0.6 (1 - f/250),   z = 0.9 d,   1 <= cot theta <= 2.5
// with the theta for which the two are equal, or the nearest (alpha_cw = 1). d is that of the bars on the
// stretched side.
#pragma once

#include "protocol/sections/capacity.hpp"
#include "protocol/sections/section_shape.hpp"

namespace adit::sections {

struct ShearMaterials {
  double cylinder_strength;  // f: f_ck, or the mean strength where values are means [Pa]
  double partial_factor;     // gamma_c, 1 where values are means
  double design_strength;    // f_cd [Pa]
  double stirrup_yield = 0;  // f_ywd [Pa]
  double stirrup_area = 0;   // A_sw/s over the section's width [m^2/m]
};

// Positive [N]. `bending`: the side that the moment stretches.
double shear_capacity(const SectionShape& shape, const ShearMaterials& materials, Bending bending,
                      double thrust);

}  // namespace adit::sections
