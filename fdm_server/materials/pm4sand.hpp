// PM4Sand version 3.1 (Boulanger & Ziotopoulou 2017, report UCD/CGM-17/01, University of California, Davis):
// sand under cyclic shear, in plane strain and effective stress.
//
// The law knows the stress in the plane only: p = (sxx + syy)/2 and s, the vector of (sxx - syy)/2 and sxy;
// here pressure and compaction are positive. The yield surface |s/p - alpha| = m/2 is small and follows its
// back-stress ratio alpha, which tends to the bounding surface M^b. The plastic modulus follows from the way
// to that surface and from the way since the last reversal, alpha - alpha_in. Sand contracts until it meets
// the dilatancy surface M^d, and dilates beyond. Both surfaces move with the relative state
//   xi = R/(Q - ln(100 p/pA)) - D_R,
// so that p stays well below e^Q pA/100 = 22 MPa. Where sand dilates its fabric z grows, by which it
// contracts the more after the next reversal.
//
// Elasticity is that of plane strain, with G ~ sqrt(p) and nu = 0.3; the plastic change of volume is the same
// in all directions. The secondary parameters are the report's defaults (pm4sand_point.hpp).
//
// After shaking, sand that has liquefied reconsolidates by more than its moduli would let it. G and K are
// multiplied by
//   F_sed = F_min + (1 - F_min) (p/(20 p_sed))^2 <= 1,   F_min = 0.03 exp(2.6 D_R) <= 0.99,
//   p_sed = pA/5 z_cum/(z_cum + z_max) <1 - M_cur/M^d>^(1/4),   M_cur = 2 |s|/p.
// The time from which they are is the user's. OpenSees has p/(20 p_sed) without the square.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fdm_server/materials/solid.hpp"

namespace adit::fdm {

inline constexpr double kPm4SandPoisson = 0.3;                                                       // nu
inline constexpr double kPm4SandBulk = 2 * (1 + kPm4SandPoisson) / (3 * (1 - 2 * kPm4SandPoisson));  // K/G
inline constexpr double kPm4SandSine = 0.5446390350150271;  // sin(phi_cv), phi_cv = 33 degrees

struct Pm4Sand {
  double relative_density;         // D_R at the begin, 0 … 1
  double modulus_coefficient;      // G0: G = G0 pA sqrt(p/pA) at small strains
  double contraction_rate;         // h_po
  double largest_pressure = 22e6;  // beyond which G stays [Pa]
  // From when on it reconsolidates [s]: G and K then are F_sed of what they would be.
  double reconsolidation_from = HUGE_VAL;
};

// The report's G0 of sand of this relative density: 167 sqrt((N1)60 + 2.5), (N1)60 = 46 D_R^2.
double modulus_coefficient(double relative_density);

// A deviatoric tensor in the plane, by its xx and xy.
struct PlaneVector {
  double t, s;
};

struct Pm4SandStress {
  double pressure;    // p [Pa]
  PlaneVector shear;  // s [Pa]
};

// What a point remembers. Vectors stand first.
struct Pm4SandState {
  PlaneVector alpha;                 // back-stress ratio
  PlaneVector start;                 // alpha_in: alpha at the last reversal
  PlaneVector apparent, before;      // the apparent alpha_in, of this way and of the one before
  PlaneVector least, most;           // alpha_in that were the least above 0, the most below 0, by component
  PlaneVector fabric, fabric_start;  // z, and z at the last reversal
  double fabric_sum, fabric_peak;    // z_cum, z_peak
  double fabric_pressure;            // p_zp, where z p was largest at a reversal [Pa]
  double fabric_product;             // that z p; below 0 before the first reversal
  double density;                    // D_R
  double shear_modulus;              // G, without F_sed [Pa]
  double reduction;                  // F_sed, 1 before the sand reconsolidates
  // From the stress at the begin.
  double least_pressure;  // p_min [Pa]
  double largest_fabric;  // z_max
  double dilatancy;       // A_do
};
inline constexpr std::size_t kPm4SandFields = sizeof(Pm4SandState) / sizeof(double);
inline constexpr std::size_t kPm4SandVectors = 8;

// The state before the first strain: alpha is the stress ratio, there is no fabric. A pressure below p_min/5
// is raised to it, a stress ratio beyond both surfaces is brought back.
Pm4SandState begin(const Pm4Sand& sand, Pm4SandStress& stress);

// Points that are strained together: increments of strain, stresses [Pa], and the fields of the states in
// their order.
struct Pm4SandPoints {
  std::uint32_t count;
  const double *compaction, *difference, *shear;  // -(exx + eyy), -(exx - eyy), -gamma_xy
  double *pressure, *shear_t, *shear_s;
  std::array<double*, kPm4SandFields> state;
};

// Strains the points. An increment whose compaction or shear strain exceeds kLargestPart is taken in equal
// parts, each by a step of Euler's: cycles to liquefaction then are those of the limit to 3 %.
// `reconsolidates`: whether the shaking is over.
inline constexpr double kLargestPart = 1e-5;
void advance(const Pm4Sand& sand, const Pm4SandPoints& points, bool reconsolidates = false);

// K, and G = G0 pA sqrt(p/pA) up to the largest pressure, which the law reaches without shear stress and
// fabric and never exceeds at p.
Elasticity small_strain_elasticity(const Pm4Sand& sand, double pressure);

// Per volume [J/m^3], of p, s.s and G: what elastic compaction with K + G/3 ~ sqrt(p) has stored, 2/3 p^2/(K
// + G/3), and what the shear stress has, s.s/(2 G).
[[gnu::always_inline]] inline double stored_energy(double pressure, double shear_squared, double modulus) {
  return (2 / (3 * (kPm4SandBulk + 1.0 / 3)) * pressure * pressure + 0.5 * shear_squared) / modulus;
}

}  // namespace adit::fdm
