// A facet bond: two rigid cells of Voronoi joined over the whole facet between them, by springs that are
// spread over it and that soften when they break (rigid-body-spring network: Bolander & Saito 1998, Eng.
// Fract. Mech. 61, 569; softening by a fracture energy: Carol, Prat & Lopez 1997, J. Eng. Mech. 123, 765).
// Per metre of thickness.
//
// At a point of the facet D is the jump of displacement from the first to the second cell, D_n along the
// facet's normal and D_t along its left normal. Intact, the traction is k D in both directions. Two points,
// at +-A / (2 sqrt 3) from the middle of a facet of length A, stand for half of it each: they give the
// bending stiffness k A^3 / 12 exactly.
//
// What is left of the strength is chi = exp(-wear). With the tensile strength f_t, the shear strength c
// without pressure and w = G_f / f_t,
//   open (D_n > 0):  sigma = whole k D_n, tau = k (D_t - slip), within (sigma / f_t)^2 + (tau / f_t)^2 <=
//   chi^2: a traction
//     beyond that is scaled back by r, `whole` by r, and slip grows by (1 - r) tau / k. The wear grows by
//     sqrt((d opening / w)^2 + (d slip / w)^2), the opening being D_n - sigma / k where it has never been
//     larger. Within the strength, too, opening wears a point whose normal stiffness shear has taken before;
//   closed:  sigma = k (D_n + closing), |tau| <= chi (f_t + (c - f_t) min(1, -2 sigma / f_t)) - sigma (mu_r +
//     (mu - mu_r) chi); what slips beyond that wears by c / G, G = G_f + (G_II - G_f) q, q = min(1, -sigma /
//     c), and adds psi q times as much to `closing`, up to psi |slip|. Where D_n + closing > 0 the point is
//     open, and this sum takes the place of D_n above.
// The cohesion is whole from a pressure of f_t / 2 on. In a body under uniaxial compression f_c, facets at a
// small angle a to it have the shear stress f_c a and the pressure f_c a^2 only; they use at most
// sqrt(f_c / (8 (c - f_t))) of their strength, 0.6 of it. With f_t instead of f_t / 2 it was 0.85, and a
// pressure that was uneven by a thousandth of f_c broke rock at 0.8 f_c.
// psi: the sides of irregular cells are inclined to a crack, those of regular hexagons by up to 30 degrees.
// Cells that slid along it under pressure would ride up on each other, so that the pressure would strengthen
// the crack, and the more so the more cells it passes. Instead their faces close by psi = tan 30 degrees, as
// if corners were crushed. Facets along a line of the scene lie straight, and have psi = 0.
// f_t and c are those at the rate with which the point is strained as it reaches its strength: (rate / 1e-6
// per second)^e times those of slow tests (fib Model Code 2010, 5.1.11.2), w as it is. The rate at which
// concrete is stronger by far, beyond 10 per second, is left to inertia, which cells have (Ozbolt et al.
// 2011, Int. J. Fract. 169, 35).
// So a facet that opens slowly dissipates f_t w = G_f, and one that is worn away bears compression and
// friction mu_r. A shear strength of f_t under tension, and friction that is lost with the cohesion, make
// strengths independent of the size of cells; with c and mu instead, irregular facets interlock.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace adit::dem {

// A strength that nothing reaches, whose square is finite [Pa].
inline constexpr double kUnbroken = 1e100;

struct FacetLaw {
  double tensile_strength, cohesion;       // f_t, c [Pa]
  double friction, residual_friction = 0;  // mu, mu_r
  double opening_energy, shearing_energy;  // G_f, G_II [J/m^2]
  bool joined = true;                      // else its cells only touch there, from the beginning
  double rate_exponent = 0;                // e
  double contraction = 0;                  // psi
  bool breaks() const { return joined && tensile_strength < kUnbroken; }
  bool operator==(const FacetLaw&) const = default;
};

// Of f_t: the pressure from which on the cohesion is whole.
inline constexpr double kFullCohesion = 0.5;
// psi of facets within a packing.
inline constexpr double kContraction = 0.57735026918962576;  // tan 30 degrees
// Where a point of a facet lies, as a share of its length from its middle.
inline constexpr double kFacetPoint = 0.28867513459481287;  // 1 / (2 sqrt 3)
// Wear by which a facet counts as cracked: a twentieth of its strength is left.
inline constexpr double kCracked = 3;

struct FacetTraction {
  double normal, shear;  // [Pa]
};

// One point that has been beyond its strength.
struct FacetPoint {
  double whole = 1, slip = 0, opening = 0, wear = 0;  // [m]
  double closing = 0;                                 // [m]
  double raised = 1;                                  // f_t and c over those of slow tests
};

inline constexpr double kSlowRate = 1e-6, kFastRate = 10;  // [1/s]

// f_t and c at this rate of strain [1/s] over those of slow tests.
inline double raised_by(const FacetLaw& law, double rate) {
  return std::pow(std::clamp(rate, kSlowRate, kFastRate) / kSlowRate, law.rate_exponent);
}

// The largest shear stress under the compression `pressure` [Pa].
inline double shear_limit(const FacetLaw& law, double chi, double pressure, double raised = 1) {
  const double closed = std::min(1.0, pressure / (kFullCohesion * raised * law.tensile_strength));
  return chi * raised * (law.tensile_strength + (law.cohesion - law.tensile_strength) * closed) +
         pressure * (law.residual_friction + (law.friction - law.residual_friction) * chi);
}

// The share of its strength in slow tests that the traction of a point uses which has not been beyond it; 1
// where it breaks.
inline double facet_demand(const FacetLaw& law, const FacetTraction& t) {
  return t.normal > 0 ? std::hypot(t.normal, t.shear) / law.tensile_strength
                      : std::abs(t.shear) / shear_limit(law, 1, -t.normal);
}

inline FacetTraction open_traction(const FacetLaw& law, double k, double jump_n, double jump_t,
                                   FacetPoint& point) {
  FacetTraction t{point.whole * k * jump_n, k * (jump_t - point.slip)};
  const double chi = std::exp(-point.wear),
               size = std::hypot(t.normal, t.shear) / (point.raised * law.tensile_strength),
               width = law.opening_energy / law.tensile_strength;
  double slipped = 0;
  if (size <= chi && point.whole == 1) return t;  // rounding opens nothing
  if (size > chi) {
    const double r = chi / size;
    slipped = (1 - r) * t.shear / k;
    t = {r * t.normal, r * t.shear};
    point.whole *= r;
    point.slip += slipped;
  }
  const double opening = std::max(point.opening, jump_n - t.normal / k);
  point.wear += std::hypot((opening - point.opening) / width, slipped / width);
  point.opening = opening;
  return t;
}

inline FacetTraction closed_traction(const FacetLaw& law, double k, double jump_n, double jump_t,
                                     FacetPoint& point) {
  FacetTraction t{k * jump_n, k * (jump_t - point.slip)};
  const double limit = shear_limit(law, std::exp(-point.wear), -t.normal, point.raised),
               beyond = std::abs(t.shear) - limit;
  if (beyond <= 0) return t;
  const double slipped = beyond / k, pressed = std::min(1.0, -t.normal / law.cohesion);
  const double energy = law.opening_energy + (law.shearing_energy - law.opening_energy) * pressed;
  point.slip += std::copysign(slipped, t.shear);
  point.closing = std::max(point.closing, std::min(point.closing + law.contraction * pressed * slipped,
                                                   law.contraction * std::abs(point.slip)));
  point.wear += slipped * law.cohesion / energy;
  t.shear = std::copysign(limit, t.shear);
  return t;
}

inline FacetTraction facet_traction(const FacetLaw& law, double k, double jump_n, double jump_t,
                                    FacetPoint& point) {
  const double gap = jump_n + point.closing;
  return gap > 0 ? open_traction(law, k, gap, jump_t, point) : closed_traction(law, k, gap, jump_t, point);
}

}  // namespace adit::dem
