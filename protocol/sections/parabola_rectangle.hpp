// Concrete at the ultimate limit state: the parabola-rectangle diagram of EN 1992-1-1:2004, 3.1.7 (1), and of
// GB 50010-2010, 6.2.1, without tension.
//
//   sigma = -f_c (1 - (1 - |eps| / eps_c2)^n)   in compression up to eps_c2,   -f_c up to eps_cu2
//
// EN 1992-1-1, table 3.1, with f_ck in MPa:
//   eps_c2  = 0.002,  above C50/60: (2.0 + 0.085 (f_ck - 50)^0.53) / 1000
//   eps_cu2 = 0.0035, above: (2.6 + 35 ((90 - f_ck)/100)^4) / 1000
//   n       = 2,      above: 1.4 + 23.4 ((90 - f_ck)/100)^4
// GB 50010, eqs. 6.2.1-3 to 6.2.1-5, with f_cu,k in MPa:
//   n = 2 - (f_cu,k - 50)/60 <= 2,   eps_0 = 0.002 + 0.5e-5 (f_cu,k - 50) >= 0.002,
//   eps_cu = 0.0033 - 1e-5 (f_cu,k - 50) <= 0.0033
#pragma once

#include <algorithm>
#include <cmath>

namespace adit::sections {

struct ParabolaRectangle {
  double strength;                      // f_c, positive [Pa]
  double peak_strain, ultimate_strain;  // eps_c2, eps_cu2, positive
  double exponent;                      // n

  // Beyond the ultimate strain it stays, because the strain limits are the section's (capacity.hpp).
  double stress(double strain) const {
    if (strain >= 0) return 0;
    const double left = 1 + strain / peak_strain;
    if (left <= 0) return -strength;
    return -strength * (1 - (exponent == 2 ? left * left : std::pow(left, exponent)));
  }
};

// Of characteristic strengths [MPa]: of a cylinder, of a cube.
inline ParabolaRectangle eurocode_diagram(double strength, double cylinder) {
  if (cylinder <= 50) return {strength, 0.002, 0.0035, 2};
  const double fourth = std::pow(std::max(90 - cylinder, 0.0) / 100, 4);
  return {strength, (2.0 + 0.085 * std::pow(cylinder - 50, 0.53)) / 1000, (2.6 + 35 * fourth) / 1000,
          1.4 + 23.4 * fourth};
}
inline ParabolaRectangle chinese_diagram(double strength, double cube) {
  const double above = std::max(cube - 50, 0.0);
  return {strength, 0.002 + 0.5e-5 * above, 0.0033 - 1e-5 * above, 2 - above / 60};
}

}  // namespace adit::sections
