// The kernel of elastic zones: from the displacements of a batch's corners to its corner forces
// (hourglass.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "fdm_server/zones/kernel/zone_kernel.hpp"
#include "fdm_server/zones/kernel/zone_runs.hpp"

namespace adit::fdm {

// A zone's geometry and stiffness: mean gradient [1/m], area [m^2], pattern gamma (of which gamma_2 = 1/2 -
// gamma_0 and gamma_3 = -1/2 - gamma_1), kappa, mu and K [Pa].
enum Coefficient {
  kGx0,
  kGx1,
  kGy0,
  kGy1,
  kArea,
  kGamma0,
  kGamma1,
  kBulk,
  kShear,
  kKxx,
  kKyy,
  kKxy,
  kCoefficients
};
using Coefficients = std::array<double, kCoefficients>;

// Generalized stresses: p, t, s [Pa] (plane_law.hpp), Q_x, Q_y [N].
enum Component { kMean, kDeviator, kSxy, kPatternX, kPatternY, kComponents };

struct ElasticBatch {
  std::array<const double*, 4> ux, uy;  // of the first zone's corners [m]
  std::uint32_t count;
  // Either those of all zones, which may be upright rectangles: Gx1 = -Gx0, Gy1 = Gy0, gamma = h/4, Kxy = 0.
  const Coefficients* same;
  bool rectangles;
  // Or, where that is null, those of each.
  std::array<const double*, kCoefficients> each;
  std::array<const double*, kComponents> initial;  // stresses at displacement 0; all null: none
  const double* weight;                            // null: all 1
};

void elastic_forces(const ElasticBatch& batch, CornerForces& forces);

// Energy of each zone, unweighted [J].
void elastic_energies(const ElasticBatch& batch, std::span<double> energies);

// The stress of each zone, at the places from `at` on.
void elastic_stresses(const ElasticBatch& batch, std::uint32_t at, PlaneStresses& stresses);

}  // namespace adit::fdm
