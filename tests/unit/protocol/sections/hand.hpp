// Hand calculation of rectangular sections by strain compatibility, with closed integrals of the
// parabola-rectangle diagram. Depths count from the compressed face, compression is positive.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace adit::sections::test {

struct HandBars {
  double depth, area;
};

struct HandSection {
  const char* name;
  double thickness, width;
  std::vector<HandBars> bars;
  double concrete, peak, ultimate, exponent;  // f_c, eps_c2, eps_cu2, n
  double steel, limit;                        // f_y, eps_ud
  double modulus = 200e9;
};

struct HandForces {
  double thrust, moment;  // tension positive; the compressed face is stretched by a negative moment
};

// Integrals over the strain from 0 to c of the diagram and of the diagram times the strain.
inline double zeroth(const HandSection& of, double c) {
  if (c <= 0) return 0;
  const double e = of.peak, n = of.exponent, u = 1 - std::min(c / e, 1.0);
  return std::min(c, e) - e / (n + 1) * (1 - std::pow(u, n + 1)) + std::max(c - e, 0.0);
}
inline double first(const HandSection& of, double c) {
  if (c <= 0) return 0;
  const double e = of.peak, n = of.exponent, u = 1 - std::min(c / e, 1.0), within = std::min(c, e);
  return within * within / 2 -
         e * e * ((1 - std::pow(u, n + 1)) / (n + 1) - (1 - std::pow(u, n + 2)) / (n + 2)) +
         (c > e ? (c * c - e * e) / 2 : 0.0);
}

// The compressed face has this strain (compression positive), which falls with the depth.
inline HandForces hand_forces(const HandSection& of, double face, double curvature) {
  const double h = of.thickness, far = face - curvature * h;
  const double force = of.concrete * of.width / curvature * (zeroth(of, face) - zeroth(of, far));
  const double about_zero =
      of.concrete * of.width / curvature / curvature * (first(of, face) - first(of, far));
  HandForces sum{-force, about_zero - force * (face / curvature - h / 2)};
  for (const auto& [depth, area] : of.bars) {
    const double strain = face - curvature * depth;
    const double displaced =
        strain > 0 ? of.concrete * (1 - std::pow(1 - std::min(strain / of.peak, 1.0), of.exponent)) : 0;
    const double stress = std::clamp(of.modulus * strain, -of.steel, of.steel) - displaced;
    sum.thrust -= area * stress;
    sum.moment += area * stress * (h / 2 - depth);
  }
  return sum;
}

inline std::vector<HandSection> ten_sections() {
  const auto both = [](double h, double cover, double area) {
    return std::vector<HandBars>{{cover, area}, {h - cover, area}};
  };
  return {
      {"wall 0.30, C30/37", 0.30, 1, both(0.30, 0.05, 1005e-6), 20e6, 0.002, 0.0035, 2, 435e6, 0.045},
      {"wall 0.50, C40/50", 0.50, 1, both(0.50, 0.06, 2454e-6), 26.7e6, 0.002, 0.0035, 2, 435e6, 0.045},
      {"one face, C25/30", 0.40, 1, {{0.35, 1571e-6}}, 16.7e6, 0.002, 0.0035, 2, 435e6, 0.0225},
      {"unequal faces", 0.60, 1, {{0.07, 905e-6}, {0.53, 2513e-6}}, 20e6, 0.002, 0.0035, 2, 435e6, 0.045},
      {"column 0.4 by 1.0", 1.0, 0.4, both(1.0, 0.06, 3217e-6), 38e6, 0.002, 0.0035, 2, 550e6, 0.045},
      {"column, four rows",
       0.5,
       0.5,
       {{0.05, 1256e-6}, {0.18, 628e-6}, {0.32, 628e-6}, {0.45, 1256e-6}},
       17e6,
       0.002,
       0.0035,
       2,
       400e6,
       0.0675},
      {"C60/75", 0.35, 1, both(0.35, 0.05, 1571e-6), 40e6, 0.00228737, 0.0028835, 1.58954, 435e6, 0.045},
      {"C90/105", 0.45, 1, both(0.45, 0.05, 2513e-6), 60e6, 0.0026, 0.0026, 1.4, 435e6, 0.045},
      {"GB C30, HRB400", 0.35, 1, both(0.35, 0.05, 1571e-6), 14.3e6, 0.002, 0.0033, 2, 360e6, 0.01},
      {"GB C50, HRB500", 0.70, 1, {{0.06, 1901e-6}, {0.64, 3054e-6}}, 23.1e6, 0.002, 0.0033, 2, 435e6, 0.01}};
}

}  // namespace adit::sections::test
